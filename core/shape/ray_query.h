#pragma once

#include <cmath>
#include <limits>

#include "core/math/aabb.h"
#include "core/math/float_error.h"
#include "core/math/ray.h"
#include "core/math/strict_floats.h"

namespace bspview {

/// The t of a miss.
inline constexpr double no_hit = std::numeric_limits<double>::infinity();

/// Which sides of a surface a ray can hit. The front of a face is where its vertices run
/// counter-clockwise; of a sphere or cone the outside, or with negative radii the inside.
enum class Sides { both, front };

/// How a ray runs beside the axis of its largest component, kz; the other two are kx and ky.
struct RayShear {
  RayShear() = default;
  explicit RayShear(const Ray& ray) {
    // Without a branch, which no predictor could tell.
    const Vec3 sizes = magnitudes(ray.direction);
    const int xy = static_cast<int>(!(sizes.x > sizes.y));
    const int is_z = static_cast<int>(!(std::max(sizes.x, sizes.y) > sizes.z));
    constexpr int next[] = {1, 2, 0};
    kz = is_z * 2 + (1 - is_z) * xy;
    kx = next[kz];
    ky = next[kx];
    turned = {component(ray.origin, kx), component(ray.origin, ky), component(ray.origin, kz)};
    shear_x = component(ray.direction, kx) / component(ray.direction, kz);
    shear_y = component(ray.direction, ky) / component(ray.direction, kz);
  }

  int kx, ky, kz;
  Vec3 turned;  ///< the origin's components kx, ky, kz
  float shear_x, shear_y;
};

/// A ray with what every shape test needs, computed once. The tests answer with the t of the hit,
/// in units of the ray's direction, t_min < t < t_max, or with no_hit.
struct RayQuery : RayShear {
  /// `reach` bounds |p - origin| on every axis for every vertex p the ray will be tested against;
  /// without it no rounding can be bounded and every test is decided exactly, slowly. A ray that
  /// meets no triangle saves the divisions of the shear.
  explicit RayQuery(const Ray& ray, float reach = std::numeric_limits<float>::infinity(),
                    bool meets_triangles = true)
      : RayShear(meets_triangles ? RayShear(ray) : RayShear()),
        origin(ray.origin),
        direction(ray.direction),
        wide_origin(ray.origin),
        wide_direction(ray.direction),
        length2(glm::dot(wide_direction, wide_direction)),
        per_length2(1.0 / length2),
        t_min(ray.t_min),
        t_max(ray.t_max),
        reach_error(reach * unit_roundoff),
        size(largest_component(magnitudes(direction))) {}

  /// `point` seen along the ray: the ray itself is the origin of the plane. Rounding moves it by
  /// less than 8 reach_error on either axis: one unit for each difference of coordinates, three
  /// for the product, two for the last difference, which is at most 2 reach.
  Vec2 project(const Vec3& point) const {
    const float z = component(point, kz) - turned.z;
    return {(component(point, kx) - turned.x) - shear_x * z,
            (component(point, ky) - turned.y) - shear_y * z};
  }
  bool accepts(double t) const { return t_min < t && t < t_max; }

  Vec3 origin, direction;
  Vec3d wide_origin, wide_direction;  ///< the same in double
  double length2, per_length2;        ///< direction . direction and its reciprocal
  double t_min, t_max;
  float reach_error;  ///< reach x unit round-off
  float size;         ///< of the largest component of the direction
};

/// `reach` of a RayQuery against everything inside `box`.
inline float reach_of(const Aabb& box, Vec3 origin) {
  return largest_component(glm::max(magnitudes(box.lo - origin), magnitudes(box.hi - origin)));
}

}  // namespace bspview
