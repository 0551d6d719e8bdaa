#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/math/ray.h"
#include "core/scene/scene.h"

namespace bspview {

/// Reads rays: text, `ox oy oz dx dy dz [tmin tmax]` per line, `#` starts a comment, a line without
/// a number is no ray and no error. Numbers are decimal, hexadecimal (0x1.8p-3), inf or nan.
/// The error names `file_name` and the line.
Result<std::vector<Ray>> parse_rays(std::string_view text, const std::string& file_name);

/// What a closest-hit ray found; the default is a miss.
struct RayResult {
  std::uint32_t object = no_index;
  double t = std::numeric_limits<double>::infinity();
  bool operator==(const RayResult&) const = default;
};

/// `object t` per line, t with 9 digits (as %.9g); `-1 inf` for a miss.
std::string format_results(std::span<const RayResult> results);

/// `1` per line for a ray that hit something, else `0`.
std::string format_occlusion(std::span<const RayResult> results);

}  // namespace bspview
