// T22: building and rendering stop at any moment they are asked to, soon, with one error, and what
// was there before is as it was.

#include <fmt/format.h>

#include <atomic>
#include <ctime>

#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"
#include "core/render/render.h"
#include "core/render/scene_tree.h"

namespace bspview::stress {
namespace {

/// Of processor time on all threads between the wish and the end: a machine that is busy with other
/// work does not make it longer.
constexpr double allowed_milliseconds = 50.0;

/// Requests a stop at the n-th call and takes the time from then on.
class Stopper {
 public:
  explicit Stopper(int moment) : moment_(moment) {}

  void step() {
    if (steps_.fetch_add(1) != moment_) return;
    wish_ = std::clock();
    source_.request_stop();
  }
  std::stop_token token() const { return source_.get_token(); }
  bool wished() const { return source_.stop_requested(); }
  double milliseconds() const {
    return 1000.0 * static_cast<double>(std::clock() - wish_.load()) / CLOCKS_PER_SEC;
  }
  int steps() const { return steps_; }

 private:
  int moment_;
  std::atomic<int> steps_ = 0;
  std::atomic<std::clock_t> wish_ = 0;
  std::stop_source source_;
};

/// What a stopped piece of work came to.
Complaint judge_stop(const Stopper& stopper, bool ok, const std::string& message) {
  if (!stopper.wished() && ok) return std::nullopt;  // done before its moment
  const double milliseconds = stopper.milliseconds();
  if (!ok && message != "stopped") return "expected the error \"stopped\", found " + message;
  if (milliseconds <= allowed_milliseconds) return std::nullopt;
  return fmt::format("expected an end within {} ms, took {:.1f} ms", allowed_milliseconds,
                     milliseconds);
}

Complaint stop_build(const Scene& scene, Dice& dice) {
  Stopper stopper(dice.below(static_cast<int>(scene.objects.size()) * 20));
  const SceneBuildInput boxes(scene);
  BuildInput input = boxes.input();
  input.clip = [&, clip = input.clip](std::uint32_t object, const Aabb& cell) {
    stopper.step();
    return clip(object, cell);
  };
  const auto builder = static_cast<Builder>(2 + dice.below(4));
  const auto tree = build_tree(input, {.builder = builder}, stopper.token());
  return judge_stop(stopper, tree.ok(), tree.ok() ? "" : tree.error().message);
}

Complaint stop_picture(const World& world, Dice& dice) {
  Stopper stopper(dice.below(16));
  Watch watch(stopper.token());
  watch.progress = [&](double) { stopper.step(); };
  const RenderParams params{.width = 96, .height = 96};
  const auto image = render_image(world, world.scene.camera, params, watch);
  return judge_stop(stopper, image.ok(), image.ok() ? "" : image.error().message);
}

}  // namespace

Result<Trial> prepare_stops(const Setting& setting) {
  Dice maker(setting.seed);
  auto scene = make_mixed_scene(10'000, Vec3(0.0f), maker);
  scene.lights = {{Vec3(4.0f, 5.0f, 6.0f), Vec3(1.0f)}};
  scene.camera = {Vec3(2.5f, 2.0f, 3.0f), Vec3(0.0f), {0, 1, 0}, 45.0f, 0.0f, 64, 64};
  auto forest = grow_forest(std::make_shared<Scene>(std::move(scene)),
                            std::span(every_leaf_size).subspan(1, 1));
  if (!forest) return forest.error();
  const auto untouched = std::make_shared<std::vector<Tree>>((*forest)->trees);
  return Trial([subject = setting.subject, forest = *forest, untouched](Dice& dice) -> Complaint {
    const Tree& tree = forest->trees.back();
    auto complaint = dice.one_in(2) ? stop_build(*forest->scene, dice)
                                    : stop_picture({*forest->scene, tree}, dice);
    if (complaint) return complaint;
    if (tree.nodes != untouched->back().nodes || tree.references != untouched->back().references) {
      return "the tree of before has changed";
    }
    const Aabb& box = forest->brute.bounds();
    const Vec3 target = aim_at(*forest->scene, box, Aim::anywhere, dice);
    return compare_with_brute_force(subject, *forest, ray_towards(target, box, dice));
  });
}

}  // namespace bspview::stress
