#pragma once

#include <cmath>
#include <limits>

namespace bspview {

/// Unit round-off of float: a correctly rounded operation is off by a factor of at most 1 +- u.
inline constexpr float unit_roundoff = 0x1p-24f;

/// Bound on the relative error of n float operations in a row (Higham 2002, section 3.1).
constexpr float gamma_error(int n) {
  return n * unit_roundoff / (1.0f - n * unit_roundoff);
}

inline float next_up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
inline float next_down(float x) {
  return std::nextafter(x, -std::numeric_limits<float>::infinity());
}

/// Largest float <= x and smallest float >= x.
inline float round_down(double x) {
  const float f = static_cast<float>(x);
  return f > x ? next_down(f) : f;
}
inline float round_up(double x) {
  const float f = static_cast<float>(x);
  return f < x ? next_up(f) : f;
}

}  // namespace bspview
