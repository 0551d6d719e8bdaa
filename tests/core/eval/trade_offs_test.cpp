#include "core/eval/trade_offs.h"

#include <gtest/gtest.h>

#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

TEST(TradeOffs, EveryWayIsMeasuredOnTheSameRaysAndTheDefaultNeverErrs) {
  Scene scene = test::random_scene(300, 8);
  const Tree tree = *build_scene_tree(scene, {});
  RenderParams params;
  params.width = params.height = 40;
  const World world{scene, tree};
  const Reference reference(scene);
  int rounds = 0;
  std::vector<TradeOffPoint> points;
  measure_trade_offs({world, reference, scene.camera, params}, {}, [&](const auto& found) {
    ++rounds;
    points = found;
  });
  EXPECT_EQ(rounds, 9);
  ASSERT_EQ(points.size(), 12u);
  for (const TradeOffPoint& point : points) {
    EXPECT_EQ(point.rays, 1600u);
    EXPECT_GT(point.nanoseconds, 0.0);
    const bool is_default =
        point.arithmetic == Arithmetic::exact && point.traversal == Traversal::robust;
    EXPECT_TRUE(!is_default || point.wrong == 0);
  }
}

TEST(TradeOffs, WhatWasNeverWrongIsBoundedByThreeInN) {
  TradeOffPoint point;
  EXPECT_EQ(point.wrong_a_million(), 0.0);
  point.rays = 3000;
  EXPECT_DOUBLE_EQ(point.wrong_a_million(), 1000.0);
  point.wrong = 6;
  EXPECT_DOUBLE_EQ(point.wrong_a_million(), 2000.0);
}

TEST(TradeOffs, AStopEndsThem) {
  const Scene scene = test::random_scene(300, 8);
  const Tree tree = *build_scene_tree(scene, {});
  const World world{scene, tree};
  const Reference reference(scene);
  const RenderParams params;
  std::stop_source stop;
  int rounds = 0;
  measure_trade_offs({world, reference, scene.camera, params}, stop.get_token(), [&](const auto&) {
    ++rounds;
    stop.request_stop();
  });
  EXPECT_EQ(rounds, 1);
}

}  // namespace
}  // namespace bspview
