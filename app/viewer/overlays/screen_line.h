#pragma once

#include <cstdint>
#include <optional>

#include "app/viewer/overlays/line_list.h"
#include "app/viewer/overlays/screen_transform.h"

namespace bspview {

/// A line inside the picture, as a function of its major axis: the one along which it is longer.
/// Lengths in pixels.
struct ScreenLine {
  bool steep = false;                ///< the major axis is y
  float first = 0.0f, last = 0.0f;   ///< on the major axis, first <= last
  float minor = 0.0f, slope = 0.0f;  ///< at `first`, and per pixel of the major axis
  /// Reciprocal of the depth, which is linear on screen: at `first`, and per pixel.
  float inverse_depth = 0.0f, inverse_depth_slope = 0.0f;
  float half_thickness = 0.0f;  ///< along the minor axis
  std::uint32_t color = 0;      ///< as in Line

  float minor_at(float major) const { return minor + slope * (major - first); }
  float inverse_depth_at(float major) const {
    return inverse_depth + inverse_depth_slope * (major - first);
  }
};

/// The part of `line` that is in front of the eye and inside the picture, whose borders are moved
/// outwards by the line's width; nullopt: nothing.
[[nodiscard]] std::optional<ScreenLine> project_line(const ScreenTransform& transform,
                                                     const Line& line);

}  // namespace bspview
