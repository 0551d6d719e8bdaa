#pragma once

#include <limits>

#include "core/math/vec.h"

namespace bspview {

/// The points origin + t * direction with t_min < t < t_max. The direction has any length but 0;
/// t counts in units of it. Sung & Shirley's walk knows no t < 0.
struct Ray {
  Vec3 origin{0.0f};
  Vec3 direction{0.0f, 0.0f, 1.0f};
  float t_min = 0.0f;
  float t_max = std::numeric_limits<float>::infinity();

  bool operator==(const Ray&) const = default;
  Vec3 at(float t) const { return origin + t * direction; }
};

}  // namespace bspview
