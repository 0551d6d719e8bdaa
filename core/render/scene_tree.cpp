#include "core/render/scene_tree.h"

#include <new>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/shape/cone.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"

namespace bspview {
namespace {

Aabb clip_object(const Scene& scene, std::uint32_t id, const Aabb& box, const Aabb& cell) {
  const Object& object = scene.objects[id];
  switch (object.kind) {
    case ObjectKind::sphere:
      return clip_sphere(scene.spheres[object.shape], cell);
    case ObjectKind::cone:
      return clip_cone(scene.cones[object.shape], cell);
    case ObjectKind::triangle:
    case ObjectKind::polygon:
      break;
  }
  return clip_polygon(vertices_of(scene, scene.faces[object.shape]), box, cell);
}

std::span<const Vec3> corners_of(const Scene& scene, std::uint32_t id) {
  const Object& object = scene.objects[id];
  if (object.kind != ObjectKind::triangle && object.kind != ObjectKind::polygon) return {};
  return vertices_of(scene, scene.faces[object.shape]);
}

}  // namespace

SceneBuildInput::SceneBuildInput(const Scene& scene, const TestCosts& test_costs,
                                 const std::stop_token& stop)
    : scene_(scene), test_costs_(test_costs), mean_test_cost_(mean_test_cost(test_costs, scene)) {
  constexpr std::size_t range_size = 4096;
  boxes_.resize(scene.objects.size());
  parallel_ranges(boxes_.size(), range_size, [&](std::size_t first, std::size_t last) {
    if (stop.stop_requested()) return;
    for (std::size_t i = first; i < last; ++i) {
      const auto id = static_cast<std::uint32_t>(i);
      boxes_[i] = is_degenerate(scene, id) ? Aabb{} : object_bounds(scene, id);
    }
  });
}

BuildInput SceneBuildInput::input() const {
  return {
      .boxes = boxes_,
      .clip = [this](std::uint32_t id,
                     const Aabb& cell) { return clip_object(scene_, id, boxes_[id], cell); },
      .corners = [this](std::uint32_t id) { return corners_of(scene_, id); },
      .cost_intersection = mean_test_cost_,
      .test_cost =
          [this](std::uint32_t id) { return test_cost(test_costs_, scene_, scene_.objects[id]); }};
}

Result<Tree> build_scene_tree(const Scene& scene, const BuildParams& params, const Watch& watch,
                              const TestCosts& test_costs) {
  const Timer timer;
  Result<Tree> tree = Error{};
  try {
    with_threads(params.threads, [&] {
      tree = build_tree(SceneBuildInput(scene, test_costs, watch.stop).input(), params, watch);
    });
  } catch (const std::bad_alloc&) {
    tree = no_memory_for_tree();
  }
  if (tree) tree->build_seconds = timer.seconds();  // the objects' boxes are part of it
  return tree;
}

}  // namespace bspview
