#pragma once

#include "core/math/vec.h"

namespace bspview {

/// Lateral surface of a cone frustum or, with equal radii, of a cylinder; open at both ends.
/// Both radii negative: only the inside is visible (under one-sided rules).
struct Cone {
  Vec3 base{0.0f};
  float base_radius = 1.0f;
  Vec3 apex{0.0f, 0.0f, 1.0f};
  float apex_radius = 0.0f;
  bool operator==(const Cone&) const = default;
};

}  // namespace bspview
