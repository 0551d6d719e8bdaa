#include "app/viewer/script.h"

#include <gtest/gtest.h>

#include "app/viewer/key.h"

namespace bspview {
namespace {

ScriptStep only_step(const std::string& line) {
  return parse_script(line, "s.txt")->front();
}

TEST(Script, HasOneStepALineAndComments) {
  const auto steps = parse_script("# a story\n\nwait\n  move build.depth 0.3  # drag\r\n", "s.txt");
  ASSERT_TRUE(steps);
  ASSERT_EQ(steps->size(), 2u);
  EXPECT_EQ((*steps)[1].kind, ScriptStep::Kind::move);
  EXPECT_EQ((*steps)[1].text, "build.depth 0.3");
  EXPECT_EQ((*steps)[1].place, "s.txt:4");
}

TEST(Script, AnUnknownCommandIsNamedWithItsLine) {
  const auto steps = parse_script("wait\njump 3\n", "s.txt");
  ASSERT_FALSE(steps);
  EXPECT_EQ(steps.error().message, "s.txt:2: no command 'jump'");
}

TEST(Script, APlaceIsAPointOrAPartOfAWidget) {
  const WidgetMap widgets{{"slider", {10, 20, 100, 10}}};
  EXPECT_EQ(*find_place(only_step("move 3 4.5"), widgets), Vec2(3, 4.5f));
  EXPECT_EQ(*find_place(only_step("move slider"), widgets), Vec2(60, 25));
  EXPECT_EQ(*find_place(only_step("move slider 0.1"), widgets), Vec2(20, 25));
  const auto missing = find_place(only_step("move button"), widgets);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().message, "s.txt:1: no widget 'button' is on the screen");
}

TEST(Script, AChordPressesAllItsKeysBeforeItReleasesThem) {
  const auto events = chord_events(only_step("key Ctrl+z"));
  ASSERT_TRUE(events);
  ASSERT_EQ(events->size(), 4u);
  EXPECT_EQ((*events)[0].code, key::left_control);
  EXPECT_EQ((*events)[1].code, 'Z');
  EXPECT_TRUE((*events)[1].down);
  EXPECT_FALSE((*events)[2].down);
  EXPECT_EQ(chord_events(only_step("key F12"))->front().code, key::f12);
  EXPECT_FALSE(chord_events(only_step("key F77")));
  EXPECT_FALSE(chord_events(only_step("key Hyper+X")));
}

}  // namespace
}  // namespace bspview
