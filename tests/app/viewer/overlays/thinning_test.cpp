#include "app/viewer/overlays/thinning.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(Thinning, SettlesWhereTheBudgetIsMet) {
  // A made-up overlay whose time falls with the square of the smallest cell.
  const auto time_of = [](float min_pixels) { return 400.0f / (min_pixels * min_pixels); };
  float min_pixels = 1.0f;
  for (int frame = 0; frame < 10; ++frame) {
    min_pixels = next_min_pixels(min_pixels, time_of(min_pixels), 16.0f);
  }
  EXPECT_NEAR(time_of(min_pixels), 16.0f, 1.0f);
}

TEST(Thinning, ReturnsToTheFinestWhenThereIsTime) {
  float min_pixels = 40.0f;
  for (int frame = 0; frame < 10; ++frame) min_pixels = next_min_pixels(min_pixels, 0.5f, 16.0f);
  EXPECT_EQ(min_pixels, 1.0f);
}

TEST(Thinning, OneSlowFrameAtMostDoublesTheSmallestCell) {
  EXPECT_EQ(next_min_pixels(4.0f, 10000.0f, 16.0f), 8.0f);
  EXPECT_LE(next_min_pixels(64.0f, 10000.0f, 16.0f), 64.0f);
}

}  // namespace
}  // namespace bspview
