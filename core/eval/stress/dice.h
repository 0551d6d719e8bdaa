#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/math/vec.h"

namespace bspview::stress {

/// The random numbers of one trial: they depend on the seed, the check, the scene and the number of
/// the trial alone, so that every trial can be run again by itself.
/// SplitMix64 (Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators").
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  Dice(std::uint64_t seed, std::string_view check, std::string_view scene, std::int64_t trial)
      : state_(seed) {
    for (const std::string_view word : {check, scene}) {
      for (const char letter : word) stir(static_cast<unsigned char>(letter));
      stir(0x100);
    }
    stir(static_cast<std::uint64_t>(trial));
    trial_ = trial;
  }

  /// Number of the trial: for what is to take turns.
  std::int64_t trial() const { return trial_; }

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Any float at all: denormal, infinite, not a number.
  float any_float() { return std::bit_cast<float>(static_cast<std::uint32_t>(bits() >> 32)); }

  /// In [0, 1), 24 bits.
  float unit() { return static_cast<float>(bits() >> 40) * 0x1p-24f; }
  float between(float lo, float hi) { return lo + (hi - lo) * unit(); }
  /// 10 to a power between `lo` and `hi`.
  float power_of_ten(float lo, float hi) { return std::pow(10.0f, between(lo, hi)); }
  /// 0 .. n - 1.
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  bool one_in(int n) { return below(n) == 0; }
  float sign() { return one_in(2) ? -1.0f : 1.0f; }

  /// In the cube of side 2 `size` around 0.
  Vec3 point(float size) {
    const float x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }
  /// Unit vector, evenly over the sphere.
  Vec3 direction() {
    for (;;) {
      const Vec3 v = point(1.0f);
      const float length2 = glm::dot(v, v);
      if (length2 > 0.01f && length2 <= 1.0f) return v / std::sqrt(length2);
    }
  }

 private:
  void stir(std::uint64_t value) {
    state_ ^= value;
    state_ = bits();
  }

  std::uint64_t state_;
  std::int64_t trial_ = 0;
};

}  // namespace bspview::stress
