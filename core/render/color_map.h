#pragma once

#include <span>
#include <string_view>

#include "core/math/vec.h"

namespace bspview {

/// Sequential colour maps: lightness grows with the value, readable with every kind of sight.
enum class ColorMap { viridis, cividis, magma, grey };

/// Names as shown to the user, in the order of the enumerators.
std::span<const std::string_view> color_map_names();

/// Colour of t in [0, 1], as displayed (sRGB, 1 is white); t outside is clamped, NaN is 0.
[[nodiscard]] Vec3 sample(ColorMap map, float t);

}  // namespace bspview
