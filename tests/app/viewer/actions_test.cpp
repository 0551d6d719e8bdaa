#include "app/viewer/actions.h"

#include <gtest/gtest.h>

#include <set>

#include "app/viewer/input_queue.h"
#include "app/viewer/interface.h"
#include "app/viewer/key.h"

namespace bspview {
namespace {

class ActionsTest : public testing::Test {
 protected:
  std::vector<Action> pressed(const std::vector<InputEvent>& events) {
    for (const InputEvent& event : events) interface_.input().push(event);
    std::vector<Action> all;
    do {
      interface_.begin_frame({}, 1.0f / 60);
      const std::vector<Action> actions = pressed_actions(ImGui::GetIO());
      all.insert(all.end(), actions.begin(), actions.end());
      interface_.end_frame();
    } while (!interface_.input().empty());
    return all;
  }

  Interface interface_;
};

std::vector<InputEvent> stroke(const Chord& chord) {
  if (chord.character != '\0') return {InputEvent::text(chord.character)};
  std::vector<InputEvent> events;
  for (const bool down : {true, false}) {
    if (chord.ctrl) events.push_back(InputEvent::key(key::left_control, down));
    events.push_back(InputEvent::key(chord.key, down));
  }
  return events;
}

TEST_F(ActionsTest, EveryChordOfTheTableDoesItsActionAndNoOther) {
  for (const KeyBinding& binding : key_bindings())
    for (const Chord& chord : binding.chords)
      EXPECT_EQ(pressed(stroke(chord)), std::vector{binding.action}) << name_of(chord);
}

TEST_F(ActionsTest, EveryActionIsInTheTableOnce) {
  std::set<Action> actions;
  for (const KeyBinding& binding : key_bindings())
    EXPECT_TRUE(actions.insert(binding.action).second) << binding.text;
  EXPECT_EQ(actions.size(), static_cast<std::size_t>(Action::help) + 1);
}

TEST_F(ActionsTest, EveryChordHasAName) {
  for (const KeyBinding& binding : key_bindings())
    for (const Chord& chord : binding.chords) {
      EXPECT_FALSE(name_of(chord).empty());
      for (const char c : name_of(chord)) EXPECT_TRUE(static_cast<unsigned char>(c) > ' ');
    }
  EXPECT_EQ(name_of({.key = 'S', .ctrl = true}), "Ctrl+S");
  EXPECT_EQ(name_of({.character = '?'}), "?");
}

TEST_F(ActionsTest, CharactersThatArriveTogetherAllCount) {
  EXPECT_EQ(pressed({InputEvent::text(']'), InputEvent::text(']'), InputEvent::text('[')}),
            (std::vector{Action::shallower, Action::deeper, Action::deeper}));
}

TEST_F(ActionsTest, APlainLetterWithCtrlIsAnotherKey) {
  EXPECT_TRUE(pressed(stroke({.key = 'B', .ctrl = true})).empty());
}

TEST(ChangeState, DepthAndLeafSizeStayWithinTheirBounds) {
  State state;
  for (int i = 0; i < 200; ++i) change_state(Action::shallower, state, 1000);
  EXPECT_EQ(state.build.max_depth, 0);
  for (int i = 0; i < 200; ++i) change_state(Action::deeper, state, 1000);
  EXPECT_EQ(state.build.max_depth, depth_cap);
  change_state(Action::smaller_leaf, state, 1000);
  EXPECT_EQ(state.build.leaf_size, 1);
}

TEST(ChangeState, TheLargestLeafSizeStaysWhereItIs) {
  State state;
  state.build.leaf_size = std::numeric_limits<int>::max();
  EXPECT_TRUE(change_state(Action::larger_leaf, state, 1));
  EXPECT_EQ(state.build.leaf_size, std::numeric_limits<int>::max());
}

TEST(ChangeState, TheFirstStepOfDepthStartsFromTheAutomaticOne) {
  State state;
  change_state(Action::deeper, state, 1000);
  EXPECT_EQ(state.build.max_depth, automatic_depth(1000) + 1);
}

TEST(ChangeState, EscapeClosesTheHelpThenDropsTheStepThenThePick) {
  State state;
  state.help_visible = true;
  state.pick = Pick{};
  state.ray.step = 3;
  change_state(Action::cancel, state, 0);
  EXPECT_FALSE(state.help_visible);
  EXPECT_EQ(state.ray.step, 3);
  change_state(Action::cancel, state, 0);
  EXPECT_EQ(state.ray.step, -1);
  EXPECT_TRUE(state.pick);
  change_state(Action::cancel, state, 0);
  EXPECT_FALSE(state.pick);
}

TEST(ChangeState, ThePickedPixelStopsAtTheBorder) {
  State state;
  state.pick = Pick{{0, 5}, {}, 10, 10};
  change_state(Action::pick_left, state, 0);
  EXPECT_EQ(state.pick->pixel, (Pixel{0, 5}));
  for (int i = 0; i < 20; ++i) change_state(Action::pick_right, state, 0);
  EXPECT_EQ(state.pick->pixel, (Pixel{9, 5}));
}

TEST(ChangeState, TheScaleStaysBetweenItsBounds) {
  State state;
  for (int i = 0; i < 100; ++i) change_state(Action::larger, state, 0);
  EXPECT_EQ(state.look.scale, largest_scale);
  for (int i = 0; i < 100; ++i) change_state(Action::smaller, state, 0);
  EXPECT_EQ(state.look.scale, least_scale);
}

TEST(ChangeState, WhatNeedsMoreThanTheStateIsLeftAlone) {
  State state;
  for (const Action action : {Action::undo, Action::redo, Action::frame, Action::reset,
                              Action::screenshot, Action::quit, Action::full_screen})
    EXPECT_FALSE(change_state(action, state, 0));
}

}  // namespace
}  // namespace bspview
