#pragma once

#include <cstdint>
#include <random>

#include "core/math/aabb.h"

namespace bspview::test {

/// Seeded random numbers; the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1), 24 bits.
  float unit() { return static_cast<float>(engine_() >> 40) * 0x1p-24f; }
  float between(float lo, float hi) { return lo + (hi - lo) * unit(); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  Vec3 point(float size) {
    const float x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }
  /// From a corner between -1 and 1 to one that is at most `size` from it along each axis.
  Aabb box(float size) {
    Aabb box;
    box.grow(point(1.0f));
    box.grow(box.lo + point(size));
    return box;
  }
  /// Unit vector, evenly over the sphere.
  Vec3 direction() {
    for (;;) {
      const Vec3 v = point(1.0f);
      const float length2 = glm::dot(v, v);
      if (length2 > 0.01f && length2 <= 1.0f) return v / std::sqrt(length2);
    }
  }
  std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace bspview::test
