#include "app/viewer/app.h"

#include <gtest/gtest.h>

#include "app/viewer/key.h"
#include "tests/gui/app_rig.h"

namespace bspview {
namespace {

/// A small scene that is there at once.
State small_scene() {
  State state;
  state.source = state.source_text = "spd:balls:2";
  state.picture.samples = 1;
  state.measure_times = false;
  return state;
}

TEST(App, ShowsTheFirstSceneWithAllItsNumbers) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(rig.results().picture);
  EXPECT_TRUE(rig.results().picture->converged());
  EXPECT_EQ(rig.results().scene->counts.objects, 92u);
  ASSERT_TRUE(rig.results().now);
  EXPECT_TRUE(rig.results().now->delta.n_at);
  EXPECT_FALSE(rig.results().before);
}

TEST(App, DraggingASliderIsOneStepOfUndoAndOneComparison) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  const std::uint64_t leaves = rig.results().now->delta.n_ls;
  rig.move(rig.point_of("build.leaf_size", 0.05f));
  rig.press();
  for (const float share : {0.1f, 0.3f, 0.5f, 0.7f}) {
    rig.move(rig.point_of("build.leaf_size", share));
    ASSERT_TRUE(rig.settle());
  }
  EXPECT_GT(rig.state().build.leaf_size, 3);
  EXPECT_LT(rig.results().now->delta.n_ls, leaves);
  EXPECT_EQ(rig.results().before->delta.n_ls, leaves);
  rig.release();
  rig.act();
  rig.app().perform(Action::undo);
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.state().build.leaf_size, 1);
  EXPECT_EQ(rig.results().now->delta.n_ls, leaves);
  rig.app().perform(Action::redo);
  EXPECT_GT(rig.state().build.leaf_size, 3);
}

TEST(App, TheCostOfATestCanBeSetAndLeftToTheProgramAgain) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  const float measured = rig.results().tree->tree.cost_intersection;
  rig.move(rig.point_of("build.cost_intersection", 0.5f));
  rig.act();
  rig.press();
  rig.act();
  rig.move(rig.point_of("build.cost_intersection", 0.9f));
  rig.act();
  rig.release();
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(rig.state().build.cost_intersection);
  EXPECT_GT(*rig.state().build.cost_intersection, measured);
  rig.click(rig.middle_of("build.auto_cost"));
  ASSERT_TRUE(rig.settle());
  EXPECT_FALSE(rig.state().build.cost_intersection);
  EXPECT_EQ(rig.results().tree->tree.cost_intersection, measured);
  rig.click(rig.middle_of("build.auto_cost"));
  EXPECT_EQ(rig.state().build.cost_intersection, measured);
}

TEST(App, TheBuildOfACutTreeIsTimedAtRest) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  EXPECT_TRUE(rig.results().now->lambda.t_cb);
  rig.app().state().build.max_depth = 5;
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.results().tree->origin, BuiltTree::Origin::cut);
  EXPECT_FALSE(rig.results().now->lambda.t_cb);
  rig.app().state().measure_times = true;
  ASSERT_TRUE(rig.settle());
  EXPECT_TRUE(rig.results().now->lambda.t_cb);
}

TEST(App, ABrokenSceneLeavesTheOldOneAndASentence) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  rig.app().open("/nowhere/at/all.nff");
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(rig.results().scene_error);
  EXPECT_NE(rig.results().scene_error->message.find("/nowhere/at/all.nff"), std::string::npos);
  EXPECT_EQ(rig.results().scene->counts.objects, 92u);
  EXPECT_TRUE(rig.results().picture);
}

TEST(App, ATreeNeverChangesThePixels) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  const auto pixels = rig.results().picture->pixels;
  rig.app().state().build.builder = Builder::median;
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.results().picture->request.tree->request.params.builder, Builder::median);
  EXPECT_EQ(rig.results().picture->pixels, pixels);
}

TEST(App, AClickPicksThePixelUnderThePointerAndFollowsItsRays) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  const Vec2 middle = rig.middle_of("view");
  rig.click(middle);
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(rig.state().pick);
  EXPECT_EQ(rig.state().pick->pixel.column, static_cast<int>(middle.x - rig.app().view().x));
  ASSERT_TRUE(rig.results().rays);
  EXPECT_FALSE(rig.results().rays->rays.front().log.steps.empty());
  ASSERT_TRUE(rig.results().overlay);
  EXPECT_GT(rig.results().overlay->lines, 0u);
  rig.key(key::right);
  EXPECT_EQ(rig.state().pick->pixel.column, static_cast<int>(middle.x - rig.app().view().x) + 1);
  rig.key(key::escape);
  EXPECT_FALSE(rig.state().pick);
}

TEST(App, ADragTurnsTheCameraAndPicksNothing) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  const Camera home = rig.results().picture->request.camera;
  const Vec2 middle = rig.middle_of("view");
  rig.move(middle);
  rig.act();
  rig.press();
  rig.move(middle + Vec2(80, 10));
  rig.act();
  rig.release();
  ASSERT_TRUE(rig.settle());
  EXPECT_NE(rig.results().picture->request.camera, home);
  EXPECT_FALSE(rig.state().pick);
  rig.key('R');
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.results().picture->request.camera, home);
}

TEST(App, WhatIsTypedRightAfterTheChordOfAFieldGoesIntoTheField) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  for (const bool down : {true, false})
    for (const int code : {key::left_control, int{'O'}}) rig.push(InputEvent::key(code, down));
  // B, F and P alone would be actions.
  const std::string name = "/bfp.nff";
  for (const char character : name) rig.push(InputEvent::text(character));
  rig.act();
  EXPECT_EQ(rig.state().source_text, name);
  EXPECT_FALSE(rig.state().boxes.visible);
  rig.key(key::enter);
  EXPECT_EQ(rig.state().source, name);
}

TEST(App, PixelsAreCheckedOnceAskedForAndTheSettingCanBeUndone) {
  AppRig rig(small_scene(), {1280, 800, 1280, 800, 1.0f});
  ASSERT_TRUE(rig.settle());
  EXPECT_FALSE(rig.results().accuracy);
  rig.click(rig.point_of("accuracy.check", 0.05f));
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(rig.results().accuracy);
  const PixelFaults& faults = rig.results().accuracy->faults;
  EXPECT_TRUE(faults.complete);
  EXPECT_EQ(faults.lost + faults.phantom + faults.self_hit, 0u);
  EXPECT_EQ(rig.results().accuracy->points.size(), 12u);
  rig.app().state().picture.arithmetic = Arithmetic::textbook;
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.results().picture->request.params.arithmetic, Arithmetic::textbook);
  EXPECT_EQ(rig.results().accuracy->request.params.arithmetic, Arithmetic::textbook);
  rig.app().perform(Action::undo);
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.results().picture->request.params.arithmetic, Arithmetic::exact);
}

TEST(App, AdaptiveSamplingNeedsMoreThanEightSamplesAndEndsThePictureEarly) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  rig.click(rig.point_of("picture.adaptive", 0.5f));
  EXPECT_EQ(rig.state().picture.adaptive, 0.0f) << "one sample: the slider is off";
  rig.click(rig.point_of("picture.samples", 0.6f));
  ASSERT_TRUE(rig.settle());
  const int uniform = rig.results().picture->pass_count;
  EXPECT_GT(rig.state().picture.samples, 40);
  EXPECT_EQ(uniform, rig.state().picture.samples + 3);
  rig.click(rig.point_of("picture.adaptive", 0.99f));
  ASSERT_TRUE(rig.settle());
  EXPECT_NEAR(rig.state().picture.adaptive, 0.1f, 0.01f);
  EXPECT_TRUE(rig.results().picture->converged());
  EXPECT_LT(rig.results().picture->pass_count, uniform);
  rig.click(rig.point_of("picture.adaptive", 0.0f));
  EXPECT_EQ(rig.state().picture.adaptive, 0.0f);
}

TEST(App, ACutOffLeavesRaysOutAndCanBeUndone) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  const RayCounts all = *rig.results().now->rays;
  rig.click(rig.point_of("picture.cutoff", 0.99f));
  ASSERT_TRUE(rig.settle());
  EXPECT_NEAR(rig.state().picture.cutoff, 0.1f, 0.01f);
  EXPECT_LT(rig.results().now->rays->reflected, all.reflected);
  EXPECT_EQ(rig.results().now->rays->primary, all.primary);
  rig.app().perform(Action::undo);
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.state().picture.cutoff, 0.0f);
  EXPECT_EQ(*rig.results().now->rays, all);
}

TEST(App, SamplesAreNoSettingToCompareNumbersOf) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  rig.app().state().build.leaf_size = 8;
  ASSERT_TRUE(rig.settle());
  const std::uint64_t before = rig.results().before->delta.n_ls;
  rig.app().state().picture.samples = 2;
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(rig.results().before->delta.n_ls, before);
}

TEST(App, OverlaysThatAreHiddenAreNotDrawn) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  EXPECT_FALSE(rig.results().overlay);
  rig.key('B');
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(rig.results().overlay);
  EXPECT_GT(rig.results().overlay->lines, 0u);
  rig.key('B');
  EXPECT_FALSE(rig.results().overlay);
}

TEST(App, NothingRunsOnceThePictureIsConverged) {
  AppRig rig(small_scene());
  ASSERT_TRUE(rig.settle());
  for (int i = 0; i < 5; ++i) rig.frame();
  EXPECT_FALSE(rig.app().busy());
  EXPECT_FALSE(rig.app().next_frame_in());
}

TEST(App, ASceneNobodyHasLeavesAnEmptyView) {
  State state = small_scene();
  state.source = "spd:nothing";
  AppRig rig(std::move(state));
  ASSERT_TRUE(rig.settle());
  EXPECT_TRUE(rig.results().scene_error);
  EXPECT_FALSE(rig.results().picture);
}

}  // namespace
}  // namespace bspview
