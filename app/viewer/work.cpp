#include "app/viewer/work.h"

#include <utility>

#include "core/render/accelerator.h"
#include "core/render/scene_tree.h"
#include "core/scene/load.h"

namespace bspview {
namespace {

constexpr double measuring_patience = 5.0;  // seconds: slow pictures are not measured five times

}  // namespace

BuiltTree::BuiltTree(const TreeRequest& of, std::shared_ptr<const Tree> made, Origin from,
                     const std::stop_token& stop)
    : request(of),
      shared(std::move(made)),
      tree(*shared),
      origin(from),
      stats(tree_stats(tree, stop)),
      cells(tree, stop) {}

World BuiltTree::fast_world(std::stop_token stop) const {
  const std::lock_guard lock(accelerating_);
  if (!accelerator_) accelerator_ = make_accelerator(world(), stop);
  return {request.scene->scene, tree, accelerator_.get()};
}

Result<void> open_scene(const SceneRequest& request, std::stop_token,
                        const Publish<LoadedScene>& publish) {
  Result<Scene> scene = load_scene(request.source);
  if (!scene) return scene.error();
  auto loaded = std::make_shared<LoadedScene>();
  loaded->source = request.source;
  loaded->counts = count_objects(*scene);
  loaded->bounds = scene_bounds(*scene);
  loaded->scene = *std::move(scene);
  publish(std::move(loaded));
  return {};
}

Result<void> follow_rays(const PathRequest& request, std::stop_token,
                         const Publish<PixelRays>& publish) {
  const Pick& pick = request.pick;
  RenderParams params = request.params;
  params.width = pick.width;
  params.height = pick.height;
  publish(std::make_shared<const PixelRays>(PixelRays{
      request, trace_pixel(request.tree->world(), pick.camera, params, pick.pixel.centre())}));
  return {};
}

Result<void> judge_picture(const AccuracyRequest& request, std::stop_token stop,
                           const Publish<Accuracy>& publish) {
  const World world = request.tree->world();
  const Reference reference(world.scene);
  const JudgedPicture picture{world, reference, request.camera, request.params};
  Accuracy accuracy{request, {}, {}};
  find_pixel_faults(picture, stop, [&](const PixelFaults& faults) {
    accuracy.faults = faults;
    publish(std::make_shared<const Accuracy>(accuracy));
  });
  if (!accuracy.faults.complete) return {};
  measure_trade_offs(picture, stop, [&](const auto& points) {
    accuracy.points = points;
    publish(std::make_shared<const Accuracy>(accuracy));
  });
  return {};
}

Result<void> take_times(const MeasureRequest& request, std::stop_token stop,
                        const Publish<Measures>& publish) {
  LambdaParams repeats;
  repeats.patience = measuring_patience;
  Result<Lambda> lambda =
      measure_lambda(request.tree->fast_world(stop), request.camera, request.params, repeats, stop);
  if (!lambda) return lambda.error();
  if (request.tree->origin == BuiltTree::Origin::cut) {
    const TreeRequest& of = request.tree->request;
    const Result<Tree> rebuilt = build_scene_tree(of.scene->scene, of.params, stop);
    if (!rebuilt) return rebuilt.error();
    lambda->t_cb = summarise({rebuilt->build_seconds});
  }
  publish(std::make_shared<const Measures>(Measures{request, *std::move(lambda)}));
  return {};
}

}  // namespace bspview
