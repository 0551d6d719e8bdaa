// Leaf boxes of a tree, drawn over a sphere that fills half of a 1280 x 800 picture. Arguments:
// leaves, threads.

#include <limits>

#include <benchmark/benchmark.h>

#include "app/viewer/overlays/line_raster.h"
#include "app/viewer/overlays/node_boxes.h"
#include "core/shape/sphere.h"
#include "tests/support/random_tree.h"

namespace bspview {
namespace {

constexpr int width = 1280, height = 800;

Camera camera() {
  Camera camera = frame_box({Vec3(0.0f), Vec3(1.0f)}, {-1.0f, -2.0f, -3.0f}, {0.0f, 1.0f, 0.0f},
                            static_cast<float>(width) / height);
  return camera;
}

/// Distances to a sphere in the middle of the unit cube.
std::vector<float> sphere_distances() {
  const PrimaryRays rays(camera(), width, height);
  std::vector<float> distances;
  for (int i = 0; i < width * height; ++i) {
    const Ray ray =
        rays.ray(static_cast<float>(i % width) + 0.5f, static_cast<float>(i / width) + 0.5f);
    const Vec3 to_centre = Vec3(0.5f) - ray.origin;
    const float a = glm::dot(ray.direction, ray.direction);
    const float b = glm::dot(to_centre, ray.direction);
    const float root = b * b - a * (glm::dot(to_centre, to_centre) - 0.2f);
    distances.push_back(root < 0.0f ? std::numeric_limits<float>::infinity()
                                    : (b - std::sqrt(root)) / a);
  }
  return distances;
}

NodeBoxStyle style_by(LeafColor color_by) {
  NodeBoxStyle style;
  style.color_by = color_by;
  style.scale = {.hi = 7.0f, .spacing = ColorScale::Spacing::logarithmic};
  return style;
}

LineList leaf_boxes(const Tree& tree, LeafColor color_by) {
  return node_box_lines(tree, filter_leaves(tree, {}), style_by(color_by));
}

void report_lines(benchmark::State& state, const LineList& lines) {
  state.counters["lines"] = static_cast<double>(lines.size());
}

void draw_leaf_boxes(benchmark::State& state, LeafColor color_by) {
  const LineList lines =
      leaf_boxes(test::make_random_tree(static_cast<int>(state.range(0)), 1), color_by);
  const std::vector<float> distances = sphere_distances();
  const LineView view{.camera = camera(),
                      .width = width,
                      .height = height,
                      .distance = distances,
                      .threads = static_cast<int>(state.range(1))};
  for (auto _ : state) benchmark::DoNotOptimize(draw_lines(lines, view));
  report_lines(state, lines);
}
BENCHMARK_CAPTURE(draw_leaf_boxes, plain, LeafColor::plain)
    ->ArgsProduct({{20'000, 200'000, 1'000'000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(draw_leaf_boxes, by_objects, LeafColor::objects)
    ->ArgsProduct({{20'000, 200'000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void collect_leaf_boxes(benchmark::State& state, LeafColor color_by, float min_pixels) {
  const Tree tree = test::make_random_tree(static_cast<int>(state.range(0)), 1);
  const LeafMask shown = filter_leaves(tree, {});
  std::optional<BoxPruning> pruning;
  if (min_pixels > 0.0f) pruning = BoxPruning{{camera(), width, height}, min_pixels};
  LineList lines;
  for (auto _ : state) lines = node_box_lines(tree, shown, style_by(color_by), pruning);
  report_lines(state, lines);
}
BENCHMARK_CAPTURE(collect_leaf_boxes, plain, LeafColor::plain, 0.0f)
    ->ArgsProduct({{20'000, 200'000, 1'000'000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(collect_leaf_boxes, plain_pruned, LeafColor::plain, 1.0f)
    ->ArgsProduct({{20'000, 200'000, 1'000'000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(collect_leaf_boxes, by_objects, LeafColor::objects, 0.0f)
    ->ArgsProduct({{20'000, 200'000, 1'000'000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(collect_leaf_boxes, by_objects_thinned, LeafColor::objects, 16.0f)
    ->ArgsProduct({{20'000, 200'000, 1'000'000}})
    ->Unit(benchmark::kMillisecond);

void mask_leaves(benchmark::State& state) {
  const Tree tree = test::make_random_tree(static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(filter_leaves(tree, {}));
}
BENCHMARK(mask_leaves)->Arg(200'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bspview
