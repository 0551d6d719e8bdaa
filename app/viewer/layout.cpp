#include "app/viewer/layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspview {
namespace {

constexpr float least_column = 200.0f;        // pixels at scale 1
constexpr float largest_column_share = 0.4f;  // of the window's width
constexpr float least_share = 0.12f, largest_share = 0.8f;

float column_width(float wished, const LayoutInput& input) {
  const float largest = largest_column_share * input.window.x / input.scale;
  return std::clamp(wished, std::min(least_column, largest), largest);
}

}  // namespace

Splits clamp_splits(const LayoutInput& input) {
  return {column_width(input.splits.left, input), column_width(input.splits.right, input),
          std::clamp(input.splits.ray, least_share, largest_share)};
}

Layout make_layout(const LayoutInput& input) {
  const auto [width, height] = std::pair{input.window.x, input.window.y};
  Layout layout;
  if (!input.panels) {
    layout.view = {0.0f, 0.0f, width, height};
    return layout;
  }
  const Splits splits = clamp_splits(input);
  const float bar = std::round(std::min(input.bar_height, height / 4));
  const float left = std::round(splits.left * input.scale);
  const float right = std::round(splits.right * input.scale);
  const float middle = height - 2 * bar;
  const float ray = std::round(splits.ray * middle);
  layout.menu = {0.0f, 0.0f, width, bar};
  layout.status = {0.0f, height - bar, width, bar};
  layout.left = {0.0f, bar, left, middle};
  layout.view = {left, bar, width - left - right, middle};
  layout.measures = {width - right, bar, right, middle - ray};
  layout.ray = {width - right, height - bar - ray, right, ray};
  return layout;
}

}  // namespace bspview
