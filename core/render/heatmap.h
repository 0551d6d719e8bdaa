#pragma once

#include <span>
#include <string_view>

#include "core/render/color_map.h"
#include "core/render/render.h"

namespace bspview {

/// What a heat map shows of each pixel's eye ray.
enum class Heat {
  nodes,   ///< visited nodes, leaves included
  tests,   ///< tested objects
  leaves,  ///< visited leaves
  depth,   ///< depth of the deepest visited leaf; 0 for a ray that misses the tree
};

/// Names as on the command line, in the order of the enumerators.
std::span<const std::string_view> heat_names();
std::string_view name_of(Heat heat);

/// One number a pixel, row-major, top row first, of the ray through the pixel's centre.
struct HeatMap {
  int width = 0, height = 0;
  std::vector<std::uint32_t> values;
  bool operator==(const HeatMap&) const = default;
};

/// Fails, with the error "stopped", only when `stop` was requested.
Result<HeatMap> measure_heat(const World& world, const Camera& camera, const RenderParams& params,
                             Heat heat, std::stop_token stop = {});

/// What the ends of the colour map stand for.
struct HeatRange {
  std::uint32_t low = 0;      ///< smallest value
  std::uint32_t high = 0;     ///< 99.5 % of the pixels are not above it
  std::uint32_t largest = 0;  ///< of all pixels; those above `high` have its colour
  bool operator==(const HeatRange&) const = default;
};
HeatRange heat_range(const HeatMap& map);

Image color_heat(const HeatMap& map, const HeatRange& range, ColorMap colors);

}  // namespace bspview
