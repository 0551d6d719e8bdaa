#include "core/render/heatmap.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/bsp/stats.h"
#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

struct SmallWorld {
  Scene scene = test::random_scene(50, 9);
  Tree tree = *build_scene_tree(scene, {});
  RenderParams params;
  SmallWorld() {
    params.width = 40;
    params.height = 30;
    params.max_ray_depth = 1;
  }
  HeatMap heat(Heat heat) const { return *measure_heat({scene, tree}, scene.camera, params, heat); }
};

std::uint64_t sum(const HeatMap& map) {
  return std::accumulate(map.values.begin(), map.values.end(), std::uint64_t{0});
}

TEST(HeatMap, PixelsAddUpToTheCountsOfThePicture) {
  SmallWorld small;
  small.scene.lights.clear();  // eye rays only
  const auto counted = render_counted({small.scene, small.tree}, small.scene.camera, small.params);
  ASSERT_TRUE(counted.ok());
  ASSERT_EQ(counted->counts.all(), 40u * 30u);
  EXPECT_EQ(sum(small.heat(Heat::nodes)), counted->counts.nodes_inner + counted->counts.nodes_leaf);
  EXPECT_EQ(sum(small.heat(Heat::leaves)), counted->counts.nodes_leaf);
  EXPECT_EQ(sum(small.heat(Heat::tests)), counted->counts.tests);
}

TEST(HeatMap, DepthIsThatOfTheDeepestVisitedLeaf) {
  const SmallWorld small;
  const HeatMap depth = small.heat(Heat::depth), leaves = small.heat(Heat::leaves);
  const PrimaryRays eye(small.scene.camera, 40, 30);
  std::vector<int> depth_of(small.tree.nodes.size());
  visit_nodes(small.tree, [&](std::uint32_t node, const Aabb&, int d) {
    depth_of[node] = d;
    return true;
  });
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const auto paths = trace_pixel({small.scene, small.tree}, small.scene.camera, small.params,
                                     {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
      int deepest = 0;
      for (const RayStep& step : paths.front().log.steps) {
        if (step.kind == StepKind::leaf) deepest = std::max(deepest, depth_of[step.node]);
      }
      ASSERT_EQ(depth.values[static_cast<std::size_t>(y * 40 + x)],
                static_cast<std::uint32_t>(deepest));
    }
  }
}

TEST(HeatMap, DoesNotDependOnTheNumberOfThreads) {
  SmallWorld one, many;
  one.params.threads = 1;
  many.params.threads = 4;
  EXPECT_EQ(one.heat(Heat::nodes), many.heat(Heat::nodes));
}

TEST(HeatMap, AStopEndsIt) {
  const SmallWorld small;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(measure_heat({small.scene, small.tree}, small.scene.camera, small.params,
                            Heat::nodes, stop.get_token())
                   .ok());
}

TEST(HeatRange, AFewExtremePixelsDoNotStretchIt) {
  HeatMap map{1000, 1, std::vector<std::uint32_t>(1000)};
  std::iota(map.values.begin(), map.values.end(), 5u);
  map.values[17] = 1'000'000;
  EXPECT_EQ(heat_range(map), (HeatRange{5, 1000, 1'000'000}));
  EXPECT_EQ(heat_range(HeatMap{}), HeatRange{});
}

TEST(HeatRange, ItsEndsAreTheEndsOfTheColourMap) {
  const HeatMap map{3, 1, {10, 20, 90}};
  const Image image = color_heat(map, {10, 20, 90}, ColorMap::grey);
  EXPECT_EQ(image.pixels, (std::vector<Vec3>{Vec3(0.0f), Vec3(1.0f), Vec3(1.0f)}));
}

TEST(HeatRange, OneValueEverywhereIsTheLowEnd) {
  const HeatMap map{2, 1, {7, 7}};
  const Image image = color_heat(map, heat_range(map), ColorMap::grey);
  EXPECT_EQ(image.pixels, std::vector<Vec3>(2, Vec3(0.0f)));
}

}  // namespace
}  // namespace bspview
