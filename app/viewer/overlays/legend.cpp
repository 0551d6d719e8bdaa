#include "app/viewer/overlays/legend.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/viewer/overlays/rgba.h"

namespace bspview {
namespace {

constexpr int color_count = 64;

/// The least of 1, 2, 5 times a power of ten that is >= x.
float round_step(float x) {
  const float decade = std::pow(10.0f, std::floor(std::log10(x)));
  for (const float digit : {1.0f, 2.0f, 5.0f}) {
    if (digit * decade >= x * 0.999f) return digit * decade;
  }
  return 10.0f * decade;
}

std::vector<float> linear_values(const ColorScale& scale, int count) {
  std::vector<float> values;
  const float step = round_step((scale.hi - scale.lo) / static_cast<float>(count));
  const float first = std::floor(scale.lo / step) + 1.0f;
  for (float i = first; i * step < scale.hi; ++i) values.push_back(i * step);
  return values;
}

/// 1, 2, 5, 10, ... above the low end, each n-th of them so that there are at most `count`.
std::vector<float> logarithmic_values(const ColorScale& scale, int count) {
  std::vector<float> all;
  for (float decade = 1.0f; scale.lo + decade < scale.hi; decade *= 10.0f) {
    for (const float digit : {1.0f, 2.0f, 5.0f}) all.push_back(scale.lo + digit * decade);
  }
  std::erase_if(all, [&](float value) { return value >= scale.hi; });
  const std::size_t stride = (all.size() + count - 1) / count;
  std::vector<float> values;
  for (std::size_t i = 0; i < all.size(); i += stride) values.push_back(all[i]);
  return values;
}

}  // namespace

Legend make_legend(const ColorScale& scale, std::string title, int max_ticks) {
  constexpr float nearest = 0.08f;  // of two labels, in lengths of the bar
  Legend legend;
  legend.title = std::move(title);
  for (int i = 0; i < color_count; ++i) {
    const float position = static_cast<float>(i) / (color_count - 1);
    legend.colors.push_back(pack_color(color_at(scale, position)));
  }
  const auto tick = [&](float position, float value) {
    legend.ticks.push_back({position, fmt::format("{:g}", value)});
  };
  tick(0.0f, scale.lo);
  if (!(scale.hi > scale.lo)) return legend;
  const bool linear = scale.spacing == ColorScale::Spacing::linear;
  const int between = std::max(max_ticks - 2, 1);
  for (const float value :
       linear ? linear_values(scale, between + 1) : logarithmic_values(scale, between)) {
    const float position = position_on(scale, value);
    const bool free = position - legend.ticks.back().position >= nearest;
    if (free && position <= 1.0f - nearest) tick(position, value);
  }
  tick(1.0f, scale.hi);
  return legend;
}

std::string legend_title(LeafColor color_by) {
  switch (color_by) {
    case LeafColor::objects:
      return "Objects per leaf";
    case LeafColor::depth:
      return "Depth of leaf";
    case LeafColor::plain:
      break;
  }
  return "";
}

}  // namespace bspview
