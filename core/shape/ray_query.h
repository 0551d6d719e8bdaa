#pragma once

#include <cmath>
#include <limits>

#include "core/math/ray.h"

namespace bspview {

inline constexpr double no_hit = std::numeric_limits<double>::infinity();

/// Which sides of a surface a ray can hit. The front of a face is where its vertices run
/// counter-clockwise; of a sphere or cone the outside, or with negative radii the inside.
enum class Sides { both, front };

/// Where a ray meets a shape.
struct ShapeHit {
  double t = no_hit;         ///< in units of the ray's direction; within 2 ulp of double
  float u = 0.0f, v = 0.0f;  ///< triangles: weights of the second and third vertex
  bool operator==(const ShapeHit&) const = default;
};

/// A ray with what every shape test needs, computed once. Shapes report only hits with
/// t_min < t < t_max.
struct RayQuery {
  explicit RayQuery(const Ray& ray)
      : origin(ray.origin), direction(ray.direction), t_min(ray.t_min), t_max(ray.t_max) {
    const Vec3 size = glm::abs(direction);
    kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
    shear_x = direction[kx] / direction[kz];
    shear_y = direction[ky] / direction[kz];
  }

  /// `point` seen along the ray: the ray itself is the origin of the plane.
  Vec2 project(Vec3 point) const {
    const Vec3 p = point - origin;
    return {p[kx] - shear_x * p[kz], p[ky] - shear_y * p[kz]};
  }
  bool accepts(double t) const { return t_min < t && t < t_max; }

  Vec3 origin, direction;
  double t_min, t_max;
  int kx, ky, kz;  ///< kz: axis of the largest component of the direction
  float shear_x, shear_y;
};

}  // namespace bspview
