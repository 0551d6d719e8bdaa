#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/viewer/overlays/color_scale.h"
#include "app/viewer/overlays/node_boxes.h"

namespace bspview {

struct LegendTick {
  float position = 0.0f;  ///< 0: low end, 1: high end
  std::string label;
  bool operator==(const LegendTick&) const = default;
};

/// What a colour bar beside the picture says.
struct Legend {
  std::string title;
  std::vector<std::uint32_t> colors;  ///< RGBA, evenly spaced from the low to the high end
  std::vector<LegendTick> ticks;      ///< ascending
};

/// At most `max_ticks` round values (at least the two ends).
[[nodiscard]] Legend make_legend(const ColorScale& scale, std::string title, int max_ticks = 6);

/// "Objects per leaf", "Depth of leaf", "".
[[nodiscard]] std::string legend_title(LeafColor color_by);

}  // namespace bspview
