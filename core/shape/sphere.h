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

/// The quadratic in double, its discriminant from the ray's closest point to the centre
/// (Haines et al. 2019, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems 7):
/// right to an ulp of float at distances of 1e6 radii.
inline ShapeHit hit_sphere(const RayQuery& ray, const Sphere& sphere, Sides sides) {
  const Vec3d d(ray.direction);
  const Vec3d f = Vec3d(ray.origin) - Vec3d(sphere.centre);
  const double r2 = static_cast<double>(sphere.radius) * sphere.radius;
  const double a = glm::dot(d, d);
  const double b = -glm::dot(f, d);
  const Vec3d closest = f + (b / a) * d;
  const double discriminant = r2 - glm::dot(closest, closest);
  if (!(discriminant >= 0.0)) return {};
  const double root = std::sqrt(a * discriminant);
  const double q = b >= 0.0 ? b + root : b - root;
  const double c = glm::dot(f, f) - r2;
  const double other = q == 0.0 ? 0.0 : c / q;  // q == 0: the ray starts in a point sphere
  const double enter = b >= 0.0 ? other : q / a;
  const double leave = b >= 0.0 ? q / a : other;
  const bool outside_visible = sides == Sides::both || sphere.radius > 0.0f;
  if (outside_visible && ray.accepts(enter)) return {enter};
  const bool inside_visible = sides == Sides::both || sphere.radius < 0.0f;
  if (inside_visible && ray.accepts(leave)) return {leave};
  return {};
}

/// Rounded outwards.
Aabb sphere_bounds(const Sphere& sphere);

/// Box of the part of the surface inside `cell`; empty when the cell lies in or out of the ball.
Aabb clip_sphere(const Sphere& sphere, const Aabb& cell);

}  // namespace bspview
