#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "core/math/vec.h"

namespace bspview {

/// How points lie to a height on one axis.
struct Heights {
  static constexpr std::size_t most = 64;

  std::uint64_t below = 0;                                 ///< bit i: point i is below
  float nearest = std::numeric_limits<float>::infinity();  ///< the least distance

  /// `height` of point i over the other height.
  void add(std::size_t i, float height) {
    below |= std::uint64_t{std::bit_cast<std::uint32_t>(height) >> 31} << i;
    nearest = std::min(nearest, std::abs(height));
  }
};

/// Of at most Heights::most points.
Heights heights_of(std::span<const Vec3> points, int axis, float height);

}  // namespace bspview
