#pragma once

#include "core/math/aabb.h"
#include "core/shape/ray_query.h"

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

/// What hit_cone needs to know of a cone, in double.
struct ConeFrame {
  explicit ConeFrame(const Cone& cone);

  Vec3d base, axis;            ///< axis: from the base to the apex
  double axis2, per_axis2;     ///< axis . axis and its reciprocal
  double base_radius, growth;  ///< radius at s of the axis: base_radius + s growth, >= 0
  double widest2;              ///< square of the largest radius
  bool is_inside_out;          ///< negative radii: seen from the inside
  bool operator==(const ConeFrame&) const = default;
};

/// In double, solved around the ray's closest point to the middle of the axis.
double hit_cone(const RayQuery& ray, const ConeFrame& cone, Sides sides);

/// Rounded outwards.
Aabb cone_bounds(const Cone& cone);

/// Box of the part inside `cell` (of whole circles: it may be a little too big); empty when no
/// circle of the cone reaches the cell.
Aabb clip_cone(const Cone& cone, const Aabb& cell);

/// Unit normal at `point` on the surface, away from the axis.
Vec3d cone_normal(const Cone& cone, Vec3d point);

}  // namespace bspview
