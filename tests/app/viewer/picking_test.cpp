#include "app/viewer/picking.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

using Release = PressTracker::Release;

TEST(Picking, TheCursorIsOverThePixelThatHoldsIt) {
  const PictureRect rect{{100.0f, 50.0f}, {400.0f, 300.0f}, 800, 600};  // two pixels a unit
  EXPECT_EQ(pixel_under(rect, {100.0f, 50.0f}), (Pixel{0, 0}));
  EXPECT_EQ(pixel_under(rect, {300.3f, 200.0f}), (Pixel{400, 300}));
  EXPECT_EQ(pixel_under(rect, {499.9f, 349.9f}), (Pixel{799, 599}));
  EXPECT_EQ((Pixel{3, 2}.index(800)), 1603u);
  EXPECT_EQ((Pixel{3, 2}.centre()), Vec2(3.5f, 2.5f));
}

TEST(Picking, BesideThePictureThereIsNoPixel) {
  const PictureRect rect{{100.0f, 50.0f}, {400.0f, 300.0f}, 800, 600};
  EXPECT_FALSE(pixel_under(rect, {99.9f, 60.0f}));
  EXPECT_FALSE(pixel_under(rect, {500.0f, 60.0f}));
  EXPECT_FALSE(pixel_under(rect, {110.0f, 350.0f}));
  EXPECT_FALSE(pixel_under({{0.0f, 0.0f}, {0.0f, 0.0f}, 0, 0}, {0.0f, 0.0f}));
}

TEST(Picking, AShortPressInPlaceIsAClick) {
  PressTracker mouse;
  mouse.press({10.0f, 10.0f}, 1.0);
  EXPECT_EQ(mouse.move({12.0f, 12.0f}), Vec2(0.0f));
  EXPECT_FALSE(mouse.dragging());
  EXPECT_EQ(mouse.release({12.0f, 12.0f}, 1.2), Release::click);
  EXPECT_FALSE(mouse.pressed());
}

TEST(Picking, FourUnitsMakeADragWithAllItsMovement) {
  PressTracker mouse;
  mouse.press({10.0f, 10.0f}, 1.0);
  EXPECT_EQ(mouse.move({13.0f, 10.0f}), Vec2(0.0f));
  EXPECT_EQ(mouse.move({15.0f, 10.0f}), Vec2(5.0f, 0.0f));
  EXPECT_TRUE(mouse.dragging());
  EXPECT_EQ(mouse.move({10.0f, 11.0f}), Vec2(-5.0f, 1.0f));
  EXPECT_EQ(mouse.release({10.0f, 10.0f}, 1.1), Release::end_of_drag);
}

TEST(Picking, ALongPressIsNoClick) {
  PressTracker mouse;
  mouse.press({10.0f, 10.0f}, 1.0);
  EXPECT_EQ(mouse.release({10.0f, 10.0f}, 1.3), Release::nothing);
}

TEST(Picking, AJumpBetweenPressAndReleaseIsADrag) {
  PressTracker mouse;
  mouse.press({10.0f, 10.0f}, 1.0);
  EXPECT_EQ(mouse.release({60.0f, 10.0f}, 1.05), Release::end_of_drag);
}

TEST(Picking, TwoQuickClicksInPlaceAreADoubleClickAndAThirdIsNot) {
  PressTracker mouse;
  const auto click = [&](Vec2 at, double time) {
    mouse.press(at, time);
    return mouse.release(at, time + 0.05);
  };
  EXPECT_EQ(click({10.0f, 10.0f}, 1.0), Release::click);
  EXPECT_EQ(click({11.0f, 10.0f}, 1.2), Release::double_click);
  EXPECT_EQ(click({11.0f, 10.0f}, 1.4), Release::click);
  EXPECT_EQ(click({11.0f, 10.0f}, 3.0), Release::click);
  EXPECT_EQ(click({31.0f, 10.0f}, 3.2), Release::click);
}

TEST(Picking, AReleaseWithoutAPressIsNothing) {
  PressTracker mouse;
  EXPECT_EQ(mouse.release({10.0f, 10.0f}, 1.0), Release::nothing);
  EXPECT_EQ(mouse.move({50.0f, 10.0f}), Vec2(0.0f));
}

}  // namespace
}  // namespace bspview
