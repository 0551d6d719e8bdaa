#pragma once

#include "core/math/aabb.h"
#include "core/shape/ray_query.h"

namespace bspview {

/// A negative radius: only the inside is visible (under one-sided rules).
struct Sphere {
  Vec3 centre{0.0f};
  float radius = 1.0f;
  bool operator==(const Sphere&) const = default;
};

/// The quadratic in double, its discriminant from the ray's distance to the centre, not from a
/// difference of squares (as Haines et al. 2019, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems 7): right to an ulp of float at distances of 1e6 radii.
inline double hit_sphere(const RayQuery& ray, const Sphere& sphere, Sides sides) {
  const Vec3d d = ray.wide_direction;
  const Vec3d f = ray.wide_origin - Vec3d(sphere.centre);
  const double r2 = static_cast<double>(sphere.radius) * sphere.radius;
  const double a = ray.length2;
  const Vec3d beside = glm::cross(f, d);  // as long as d and the distance
  const double discriminant = a * r2 - glm::dot(beside, beside);
  if (!(discriminant >= 0.0)) return no_hit;
  const double b = -glm::dot(f, d);
  const double root = std::sqrt(discriminant);
  const double q = b >= 0.0 ? b + root : b - root;
  const double c = glm::dot(f, f) - r2;
  const auto other = [&] { return q == 0.0 ? 0.0 : c / q; };  // q == 0: starts in a point sphere
  const bool outside_visible = sides == Sides::both || sphere.radius > 0.0f;
  const double enter = b >= 0.0 ? other() : q / a;
  if (outside_visible && ray.accepts(enter)) return enter;
  const bool inside_visible = sides == Sides::both || sphere.radius < 0.0f;
  const double leave = b >= 0.0 ? q / a : other();
  if (inside_visible && ray.accepts(leave)) return leave;
  return no_hit;
}

/// Rounded outwards.
Aabb sphere_bounds(const Sphere& sphere);

/// Box of the part of the surface inside `cell`; empty when the cell lies in or out of the ball.
Aabb clip_sphere(const Sphere& sphere, const Aabb& cell);

}  // namespace bspview
