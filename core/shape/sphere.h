#pragma once

#include "core/math/vec.h"

namespace bspview {

/// A negative radius: only the inside is visible (under one-sided rules).
struct Sphere {
  Vec3 centre{0.0f};
  float radius = 1.0f;
  bool operator==(const Sphere&) const = default;
};

}  // namespace bspview
