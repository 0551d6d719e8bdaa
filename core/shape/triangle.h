#pragma once

// Inside test after Woop, Benthin & Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1).

#include "core/math/aabb.h"
#include "core/shape/ray_query.h"

namespace bspview {

/// Twice the signed area of the triangle (0, p, q), with the exact sign: rounding of the two
/// products is monotone, so that only equal products leave it open, and those double decides
/// exactly. edge_area(p, q) == -edge_area(q, p) holds bit for bit (needs contraction off).
inline double edge_area(Vec2 p, Vec2 q) {
  const float area = p.x * q.y - p.y * q.x;
  if (area != 0.0f) return area;
  return static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x;
}

/// Not normalised; in double, so that t and the side are right even for needles.
inline Vec3d triangle_normal(Vec3 a, Vec3 b, Vec3 c) {
  return glm::cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a));
}

/// Hit of the plane through `point` with normal `normal`; no_hit for a parallel or hidden plane.
inline double hit_plane(const RayQuery& ray, Vec3d point, Vec3d normal, Sides sides) {
  const double slope = glm::dot(normal, Vec3d(ray.direction));
  if (slope == 0.0 || (sides == Sides::front && slope > 0.0)) return no_hit;
  const double t = glm::dot(normal, point - Vec3d(ray.origin)) / slope;
  return ray.accepts(t) ? t : no_hit;
}

/// Edges and vertices belong to the triangle: closed meshes have no gaps.
inline ShapeHit hit_triangle(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const Vec2 a = ray.project(vertices[0]);
  const Vec2 b = ray.project(vertices[1]);
  const Vec2 c = ray.project(vertices[2]);
  const double u = edge_area(c, b);
  const double v = edge_area(a, c);
  const double w = edge_area(b, a);
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return {};
  const double area = u + v + w;
  if (area == 0.0) return {};
  const Vec3d normal = triangle_normal(vertices[0], vertices[1], vertices[2]);
  const double t = hit_plane(ray, Vec3d(vertices[0]), normal, sides);
  return {t, static_cast<float>(v / area), static_cast<float>(w / area)};
}

/// The same in double throughout (Moeller & Trumbore 1997): the reference picture's test.
ShapeHit hit_triangle_double(const RayQuery& ray, const Vec3* vertices, Sides sides);

}  // namespace bspview
