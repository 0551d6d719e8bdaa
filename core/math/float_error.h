#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace bspview {

/// Unit round-off of float: a correctly rounded operation is off by a factor of at most 1 +- u.
inline constexpr float unit_roundoff = 0x1p-24f;

/// Bound on the relative error of n float operations in a row (Higham 2002, section 3.1).
constexpr float gamma_error(int n) {
  return n * unit_roundoff / (1.0f - n * unit_roundoff);
}

/// The next float above x; x itself when it is infinite or not a number.
inline float next_up(float x) {
  if (!(std::abs(x) < std::numeric_limits<float>::infinity())) {
    return x == -std::numeric_limits<float>::infinity() ? std::numeric_limits<float>::lowest() : x;
  }
  if (x == 0.0f) return std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::int32_t>(x);
  return std::bit_cast<float>(x > 0.0f ? bits + 1 : bits - 1);
}
inline float next_down(float x) {
  return -next_up(-x);
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
