#include "app/viewer/layout.h"

#include <gtest/gtest.h>

#include <vector>

namespace bspview {
namespace {

std::vector<Rect> regions(const Layout& layout) {
  return {layout.menu, layout.left, layout.view, layout.measures, layout.ray, layout.status};
}

float common_area(const Rect& a, const Rect& b) {
  const float width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const float height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return std::max(width, 0.0f) * std::max(height, 0.0f);
}

void expect_tiling(const LayoutInput& input) {
  const std::vector<Rect> rects = regions(make_layout(input));
  float area = 0.0f;
  for (std::size_t i = 0; i < rects.size(); ++i) {
    area += rects[i].width * rects[i].height;
    for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(common_area(rects[i], rects[j]), 0.0f);
  }
  EXPECT_EQ(area, input.window.x * input.window.y);
}

TEST(Layout, RegionsTileTheWindowAtEverySizeAndScale) {
  for (const Vec2 window : {Vec2(960, 600), Vec2(1280, 800), Vec2(3840, 2160), Vec2(320, 200)})
    for (const float scale : {0.75f, 1.0f, 2.0f, 3.0f})
      expect_tiling({.window = window, .scale = scale, .bar_height = 22 * scale, .splits = {}});
}

TEST(Layout, ThePictureKeepsAFifthOfTheWindowHoweverTheSplittersAreDragged) {
  for (const float width : {-100.0f, 0.0f, 1e6f}) {
    const Layout layout = make_layout(
        {.window = {960, 600}, .scale = 1.0f, .bar_height = 22.0f, .splits = {width, width, 0.4f}});
    EXPECT_GE(layout.view.width, 0.19f * 960);
  }
}

TEST(Layout, WithoutPanelsThePictureFillsTheWindow) {
  const Layout layout = make_layout(
      {.window = {960, 600}, .scale = 1.0f, .bar_height = 22.0f, .splits = {}, .panels = false});
  EXPECT_EQ(layout.view, (Rect{0, 0, 960, 600}));
  EXPECT_EQ(layout.menu, Rect{});
}

}  // namespace
}  // namespace bspview
