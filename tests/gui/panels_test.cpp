#include "app/viewer/panels/panels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/viewer/interface.h"
#include "app/viewer/work.h"
#include "core/scene/load.h"

namespace bspview {
namespace {

/// Everything that the stages could show of a small scene.
Results full_results() {
  Results results;
  const auto fail_unless = [](const Result<void>& result) { ASSERT_TRUE(result.ok()); };
  fail_unless(open_scene({"spd:balls:1", 0}, {}, [&](auto scene) { results.scene = scene; }));
  fail_unless(TreeWork{}({results.scene, {}}, {}, [&](auto tree) { results.tree = tree; }));
  PictureRequest request{results.tree, results.scene->scene.camera, {}};
  request.params.width = request.params.height = 32;
  fail_unless(PictureWork{}(request, {}, [&](auto picture) { results.picture = picture; }));
  const Pick pick{{16, 16}, request.camera, 32, 32};
  fail_unless(follow_rays({results.tree, request.params, pick}, {},
                          [&](auto rays) { results.rays = rays; }));
  fail_unless(judge_picture({results.tree, request.camera, request.params}, {},
                            [&](auto accuracy) { results.accuracy = accuracy; }));
  results.now = evaluate(*results.tree, results.picture.get(), nullptr);
  results.before = results.now;
  return results;
}

State full_state(const Results& results) {
  State state;
  state.view.camera = OrbitCamera(results.scene->scene.camera, results.scene->bounds);
  state.pick = Pick{{16, 16}, results.scene->scene.camera, 32, 32};
  state.boxes.visible = true;
  state.help_visible = true;
  state.check_pixels = true;
  state.notice = "Something to say.";
  return state;
}

/// Draws three frames of `size` with the pointer at `pointer`; returns the last one's widgets.
WidgetMap three_frames(const Results& results, State& state, Vec2 size, Vec2 pointer = {-1, -1}) {
  Interface interface;
  interface.set_look(state.look.theme, state.look.scale);
  WindowSize window;
  window.width = window.pixel_width = static_cast<int>(size.x);
  window.height = window.pixel_height = static_cast<int>(size.y);
  WidgetMap widgets;
  interface.input().push(InputEvent::move(pointer));
  for (int i = 0; i < 3; ++i) {
    widgets.clear();
    interface.begin_frame(window, 1.0f / 60);
    const Ui ui{interface.fonts(), interface.palette(), interface.scale(), true, widgets};
    std::vector<Action> actions;
    draw_panels(ui, size, results, state, actions);
    EXPECT_TRUE(actions.empty());
    interface.end_frame();
  }
  return widgets;
}

TEST(Panels, SurviveThreeFramesWithNothingToShow) {
  State state;
  three_frames({}, state, {960, 600});
}

TEST(Panels, SurviveThreeFramesWithEverythingToShow) {
  const Results results = full_results();
  for (const Theme theme : {Theme::dark, Theme::light})
    for (const float scale : {0.75f, 1.0f, 3.0f}) {
      State state = full_state(results);
      state.look.theme = theme;
      state.look.scale = scale;
      three_frames(results, state, {960, 600});
    }
}

TEST(Panels, SurviveThreeFramesInWindowsOfAnySize) {
  const Results results = full_results();
  for (const Vec2 size : {Vec2(1, 1), Vec2(40, 30), Vec2(320, 240), Vec2(4000, 100)}) {
    State state = full_state(results);
    three_frames(results, state, size);
  }
}

TEST(Panels, SurviveErrorsAndWorkUnderWay) {
  Results results = full_results();
  results.scene_error = Error{"scene.nff:3: a sphere needs 4 numbers"};
  results.tree_error = Error{"no memory"};
  results.scene_busy = results.tree_busy = results.picture_busy = results.measures_busy = true;
  State state = full_state(results);
  three_frames(results, state, {1280, 800});
}

TEST(Panels, EveryWidgetExplainsItselfUnderThePointer) {
  const Results results = full_results();
  State state = full_state(results);
  state.help_visible = false;
  for (const auto& [name, rect] : three_frames(results, state, {1280, 800}))
    three_frames(results, state, {1280, 800}, {rect.x + rect.width / 2, rect.y + rect.height / 2});
}

TEST(Panels, EveryControlIsInTheMapAndInsideTheSmallestWindow) {
  const Results results = full_results();
  State state = full_state(results);
  state.help_visible = false;
  const WidgetMap widgets = three_frames(results, state, {960, 600});
  state.boxes.visible = false;
  const WidgetMap without_boxes = three_frames(results, state, {960, 600});
  for (const char* name : {"picture.samples", "picture.adaptive", "picture.cutoff"}) {
    ASSERT_TRUE(without_boxes.contains(name)) << name;
    EXPECT_LE(without_boxes.at(name).bottom(), 600.0f) << name;
  }
  for (const char* name : {"scene.source",
                           "scene.standard",
                           "scene.size",
                           "build.builder",
                           "build.max_depth",
                           "build.auto_depth",
                           "build.leaf_size",
                           "build.clip",
                           "build.cost_traversal",
                           "build.cost_intersection",
                           "build.auto_cost",
                           "build.traversal",
                           "overlay.boxes",
                           "overlay.path",
                           "boxes.cells",
                           "boxes.depth",
                           "boxes.contents",
                           "boxes.color",
                           "boxes.borders",
                           "measure.N_LS",
                           "measure.N_AOIAL",
                           "measure.T_TT_over_T_TR",
                           "view",
                           "legend",
                           "ray.0",
                           "step.0",
                           "splitter.left"}) {
    ASSERT_TRUE(widgets.contains(name)) << name;
    const Rect& rect = widgets.at(name);
    EXPECT_GE(rect.x, 0.0f) << name;
    EXPECT_GE(rect.y, 0.0f) << name;
    EXPECT_LE(rect.right(), 960.0f) << name;
    EXPECT_LE(rect.bottom(), 600.0f) << name;
  }
}

TEST(Panels, ControlsOfOnePanelDoNotOverlap) {
  const Results results = full_results();
  State state = full_state(results);
  state.help_visible = false;
  const WidgetMap widgets = three_frames(results, state, {960, 600});
  std::vector<std::pair<std::string, Rect>> controls;
  for (const auto& [name, rect] : widgets)
    for (const char* panel : {"scene.", "build.", "boxes.", "overlay.", "picture.", "measure."})
      if (name.starts_with(panel)) controls.emplace_back(name, rect);
  for (const auto& [name, a] : controls)
    for (const auto& [other, b] : controls) {
      if (name >= other) continue;
      const bool apart =
          a.right() <= b.x || b.right() <= a.x || a.bottom() <= b.y || b.bottom() <= a.y;
      EXPECT_TRUE(apart) << name << " and " << other;
    }
}

TEST(Panels, AHighlightedStepFollowsThePointer) {
  const Results results = full_results();
  State state = full_state(results);
  state.help_visible = false;
  const Rect row = three_frames(results, state, {1280, 800}).at("step.1");
  three_frames(results, state, {1280, 800}, {row.x + 5, row.y + row.height / 2});
  EXPECT_EQ(state.hovered_step, 1);
}

TEST(Panels, HiddenPanelsLeaveThePictureTheWholeWindow) {
  const Results results = full_results();
  State state = full_state(results);
  state.panels_visible = false;
  state.help_visible = false;
  const WidgetMap widgets = three_frames(results, state, {960, 600});
  EXPECT_EQ(widgets.at("view"), (Rect{0, 0, 960, 600}));
  EXPECT_FALSE(widgets.contains("build.builder"));
}

TEST(Panels, GreekLettersHaveGlyphs) {
  Interface interface;
  ASSERT_TRUE(interface.fonts().greek) << "fonts-dejavu-core is not installed";
  for (const ImWchar letter : {0x394, 0x39b, 0x2212, 0x2013, 0x3a3}) {
    EXPECT_NE(interface.fonts().text->FindGlyphNoFallback(letter), nullptr) << letter;
    EXPECT_NE(interface.fonts().bold->FindGlyphNoFallback(letter), nullptr) << letter;
  }
}

}  // namespace
}  // namespace bspview
