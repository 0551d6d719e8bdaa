#include <gtest/gtest.h>

#include "core/eval/lambda.h"
#include "core/render/record.h"
#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

struct SmallWorld {
  Scene scene = test::random_scene(30, 4);
  Tree tree = *build_scene_tree(scene, {});
  RenderParams params;
  SmallWorld() { params.width = params.height = 24; }
  World world() const { return {scene, tree}; }
};

TEST(MeasureLambda, RepeatsEachMeasurementAsOftenAsAsked) {
  const SmallWorld small;
  const auto lambda =
      measure_lambda(small.world(), small.scene.camera, small.params,
                     {.build_repeats = 3, .render_repeats = 7, .replay_repeats = 5});
  ASSERT_TRUE(lambda.ok());
  EXPECT_EQ(lambda->t_cb->repeats, 3);
  EXPECT_EQ(lambda->t_tr->repeats, 7);
  EXPECT_EQ(lambda->t_tt_share->repeats, 5);
  EXPECT_GT(lambda->t_tr->median, 0.0);
  EXPECT_GE(lambda->t_tt_share->median, 0.0);
}

TEST(MeasureLambda, TheBuildOfTheTreeCounts) {
  SmallWorld small;
  small.tree.build_seconds = 123.0;
  const auto lambda =
      measure_lambda(small.world(), small.scene.camera, small.params,
                     {.build_repeats = 1, .render_repeats = 1, .replay_repeats = 0});
  EXPECT_EQ(*lambda->t_cb, (Measured{123.0, 0.0, 1}));
  EXPECT_EQ(lambda->t_tr->repeats, 1);
  EXPECT_FALSE(lambda->t_tt_share);
}

TEST(MeasureLambda, ProgressAddsUpToWhatWasPlanned) {
  SmallWorld small;
  small.params.threads = 1;
  for (const auto& [builds, renders, replays] :
       {std::array{1, 1, 5}, std::array{3, 7, 5}, std::array{2, 4, 0}}) {
    const LambdaParams repeats{builds, renders, replays};
    double done = 0.0;
    Watch watch;
    watch.progress = [&](double more) { done += more; };
    ASSERT_TRUE(
        measure_lambda(small.world(), small.scene.camera, small.params, repeats, watch).ok());
    EXPECT_NEAR(done, planned_runs(small.params, repeats), 1e-9);
  }
}

TEST(MeasureLambda, AStopEndsItWithoutAResult) {
  const SmallWorld small;
  std::stop_source stop;
  Watch watch(stop.get_token());
  watch.progress = [&](double) { stop.request_stop(); };
  const auto lambda = measure_lambda(small.world(), small.scene.camera, small.params, {}, watch);
  ASSERT_FALSE(lambda.ok());
  EXPECT_EQ(lambda.error().message, "stopped");
}

TEST(MeasureLambda, WithoutPatienceReplaysAreNotRepeated) {
  const SmallWorld small;
  LambdaParams repeats;
  repeats.patience = 0.0;
  const auto lambda = measure_lambda(small.world(), small.scene.camera, small.params, repeats);
  ASSERT_TRUE(lambda.ok());
  EXPECT_EQ(lambda->t_tt_share->repeats, 1);
  EXPECT_EQ(lambda->t_tr->repeats, 1);
}

TEST(MeasureLambda, AStoppedReplayWalksNothing) {
  const SmallWorld small;
  const auto rays = record_rays(small.world(), small.scene.camera, small.params);
  ASSERT_TRUE(rays.ok());
  std::stop_source stop;
  EXPECT_GT(replay(small.world(), small.params, *rays, Replay::walk, stop.get_token()), 0u);
  stop.request_stop();
  EXPECT_EQ(replay(small.world(), small.params, *rays, Replay::walk, stop.get_token()), 0u);
}

TEST(MeasureLambda, TheReplayVisitsTheNodesThatTheRaysVisited) {
  const SmallWorld small;
  const auto counted = render_counted(small.world(), small.scene.camera, small.params);
  const auto rays = record_rays(small.world(), small.scene.camera, small.params);
  ASSERT_TRUE(counted.ok() && rays.ok());
  EXPECT_EQ(rays->size(), counted->counts.all());
  RayCost cost;
  for (const RecordedRay& recorded : *rays) {
    std::uint32_t left = recorded.leaves;
    CountObserver observer(cost);
    traverse(
        small.params.traversal, small.tree, recorded.ray,
        [&](std::uint32_t, const Node&) { return --left == 0 ? stop_walk : no_hit; }, observer);
  }
  EXPECT_EQ(cost.inner, counted->counts.nodes_inner);
  EXPECT_EQ(cost.leaves, counted->counts.nodes_leaf);
}

TEST(RecordedPicture, IsThePictureItselfUntilItHasTooManyEyeRays) {
  RenderParams params;
  params.width = 1920;
  params.height = 1080;
  EXPECT_EQ(recorded_picture(params), params);
  params.samples = 16;
  EXPECT_EQ(recorded_picture(params).samples, 1);
  EXPECT_EQ(recorded_picture(params).width, 1920);
  params.width = params.height = 512;
  EXPECT_EQ(recorded_picture(params).samples, 8);
  params.width = params.height = 32768;
  const RenderParams small = recorded_picture(params);
  EXPECT_LE(std::int64_t{small.width} * small.height, max_recorded_pixels);
  EXPECT_EQ(small.width, small.height);
}

}  // namespace
}  // namespace bspview
