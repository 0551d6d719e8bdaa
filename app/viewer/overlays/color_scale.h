#pragma once

#include "core/render/color_map.h"

namespace bspview {

/// How a value becomes a colour; compares by value.
struct ColorScale {
  enum class Spacing { linear, logarithmic };  ///< logarithmic: in log(1 + value - lo)

  ColorMap map = ColorMap::viridis;
  float lo = 0.0f, hi = 1.0f;  ///< values of the two ends
  Spacing spacing = Spacing::linear;

  bool operator==(const ColorScale&) const = default;
};

/// Position of a value on the scale, clamped to [0, 1]; 0 when the range is empty.
[[nodiscard]] float position_on(const ColorScale& scale, float value);

/// Colour at a position in [0, 1]. The darkest fifth of the map is left out: such lines could not
/// be told from a dark picture.
[[nodiscard]] Vec3 color_at(const ColorScale& scale, float position);

}  // namespace bspview
