#pragma once

// Ray tests as textbooks give them, to be measured against those of core/shape: they answer with
// what their arithmetic makes of it, without a bound on any error.

#include <cmath>

#include "core/shape/cone.h"
#include "core/shape/polygon.h"
#include "core/shape/ray_query.h"
#include "core/shape/sphere.h"

namespace bspview {

/// A ray in the arithmetic of its tests.
template <class Real>
struct TextbookRay {
  using Vec = glm::vec<3, Real>;

  explicit TextbookRay(const Ray& ray)
      : origin(ray.origin), direction(ray.direction), t_min(ray.t_min), t_max(ray.t_max) {}
  bool accepts(Real t) const { return t_min < t && t < t_max; }

  Vec origin, direction;
  Real t_min, t_max;
};

/// Moeller & Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1); the
/// division comes last, as in their paper's second form for both sides.
template <class Real>
inline double hit_moeller_trumbore(const TextbookRay<Real>& ray, const Vec3* vertices,
                                   Sides sides) {
  using Vec = typename TextbookRay<Real>::Vec;
  const Vec corner(vertices[0]);
  const Vec edge1 = Vec(vertices[1]) - corner, edge2 = Vec(vertices[2]) - corner;
  const Vec p = glm::cross(ray.direction, edge2);
  const Real det = glm::dot(edge1, p);  // > 0: seen from the front
  if (det == Real(0) || (sides == Sides::front && det < Real(0))) return no_hit;
  const Real inverse = Real(1) / det;
  const Vec from = ray.origin - corner;
  const Real u = glm::dot(from, p) * inverse;
  if (!(u >= Real(0) && u <= Real(1))) return no_hit;
  const Vec q = glm::cross(from, edge1);
  const Real v = glm::dot(ray.direction, q) * inverse;
  if (!(v >= Real(0) && u + v <= Real(1))) return no_hit;
  const Real t = glm::dot(edge2, q) * inverse;
  if (!ray.accepts(t)) return no_hit;
  return t;
}

/// The plane, then the crossings of a half-line with the edges along the two axes on which the
/// polygon is widest (Haines 1994, "Point in Polygon Strategies", Graphics Gems IV).
template <class Real>
inline double hit_polygon_crossings(const TextbookRay<Real>& ray, std::span<const Vec3> vertices,
                                    const PolygonPlane& plane, Sides sides) {
  using Vec = typename TextbookRay<Real>::Vec;
  const Vec normal(plane.normal);
  const Real slope = glm::dot(normal, ray.direction);
  if (slope == Real(0) || (sides == Sides::front && slope > Real(0))) return no_hit;
  const Real t = glm::dot(normal, Vec(plane.point) - ray.origin) / slope;
  if (!ray.accepts(t)) return no_hit;

  const Vec size = magnitudes(normal);
  const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int x = z == 0 ? 1 : 0, y = z == 2 ? 1 : 2;
  const Real at_x = ray.origin[x] + t * ray.direction[x];
  const Real at_y = ray.origin[y] + t * ray.direction[y];
  bool inside = false;
  const Vec3* from = &vertices.back();
  bool from_above = (*from)[y] >= at_y;
  for (const Vec3& to : vertices) {
    const bool to_above = to[y] >= at_y;
    if (from_above != to_above) {
      const bool crosses = (to[y] - at_y) * (Real((*from)[x]) - to[x]) >=
                           (to[x] - at_x) * (Real((*from)[y]) - to[y]);
      if (crosses == to_above) inside = !inside;
    }
    from_above = to_above;
    from = &to;
  }
  return inside ? t : no_hit;
}

/// The quadratic formula in float, discriminant b^2 - 4 a c.
inline double hit_sphere_textbook(const TextbookRay<float>& ray, const Sphere& sphere,
                                  Sides sides) {
  const Vec3 f = ray.origin - sphere.centre;
  const float a = glm::dot(ray.direction, ray.direction);
  const float b = 2.0f * glm::dot(f, ray.direction);
  const float c = glm::dot(f, f) - sphere.radius * sphere.radius;
  const float discriminant = b * b - 4.0f * a * c;
  if (!(discriminant >= 0.0f)) return no_hit;
  const float root = std::sqrt(discriminant), scale = 0.5f / a;
  const float enter = (-b - root) * scale;
  if ((sides == Sides::both || sphere.radius > 0.0f) && ray.accepts(enter)) return enter;
  const float leave = (-b + root) * scale;
  if ((sides == Sides::both || sphere.radius < 0.0f) && ray.accepts(leave)) return leave;
  return no_hit;
}

/// The quadratic of the unbounded cone in float, in coordinates along and across its axis.
inline double hit_cone_textbook(const TextbookRay<float>& ray, const Cone& cone, Sides sides) {
  const Vec3 axis = cone.apex - cone.base, f = ray.origin - cone.base;
  const float per_axis2 = 1.0f / glm::dot(axis, axis);
  const float m = glm::dot(f, axis) * per_axis2;
  const float n = glm::dot(ray.direction, axis) * per_axis2;
  const Vec3 f_across = f - m * axis, d_across = ray.direction - n * axis;
  const float base_radius = std::abs(cone.base_radius);
  const float growth = std::abs(cone.apex_radius) - base_radius;
  const float radius = base_radius + growth * m, slope = growth * n;

  const float a = glm::dot(d_across, d_across) - slope * slope;
  const float b = 2.0f * (glm::dot(f_across, d_across) - radius * slope);
  const float c = glm::dot(f_across, f_across) - radius * radius;
  const float discriminant = b * b - 4.0f * a * c;
  if (!(discriminant >= 0.0f)) return no_hit;
  const float root = std::copysign(std::sqrt(discriminant), a), scale = 0.5f / a;
  for (const float t : {(-b - root) * scale, (-b + root) * scale}) {
    const float s = m + t * n;
    if (!(0.0f <= s && s <= 1.0f) || !ray.accepts(t)) continue;
    if (sides == Sides::front) {
      const bool enters = 2.0f * a * t + b < 0.0f;
      if (enters == (cone.base_radius < 0.0f || cone.apex_radius < 0.0f)) continue;
    }
    return t;
  }
  return no_hit;
}

}  // namespace bspview
