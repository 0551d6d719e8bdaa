#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "core/math/vec.h"

namespace bspview {

/// Seeded random numbers, the same on every machine.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1), 53 bits.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// In 0 .. n - 1; n far below 2^32.
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(unit() * static_cast<double>(n));
  }
  /// Unit vector, evenly over the sphere.
  Vec3d direction() {
    const double z = 2.0 * unit() - 1.0, angle = 2.0 * 3.14159265358979323846 * unit();
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace bspview
