#pragma once

// Inside test in the ray's plane after Woop, Benthin & Wald 2013, "Watertight Ray/Triangle
// Intersection", JCGT 2(1). Where theirs is watertight, this one is right: a sign that its error
// bound leaves open is decided exactly.

#include "core/math/aabb.h"
#include "core/shape/ray_query.h"

namespace bspview {

/// Twice the signed area of the triangle (0, p, q).
inline float edge_area(Vec2 p, Vec2 q) {
  return p.x * q.y - p.y * q.x;
}

/// Not normalised.
inline Vec3d triangle_normal(Vec3 a, Vec3 b, Vec3 c) {
  return glm::cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a));
}

/// Where a ray that is known to pass through a triangle meets it: right to an ulp of float at
/// worst, its sign always; no hit outside the ray's interval or from a hidden side.
double hit_triangle_plane(const RayQuery& ray, const Vec3* vertices, Sides sides);

/// hit_triangle with every sign decided by exact arithmetic where double leaves it open.
double hit_triangle_exactly(const RayQuery& ray, const Vec3* vertices, Sides sides);

/// The exact set of hits: edges and vertices belong to the triangle, a triangle without area or
/// seen edge-on is missed.
inline double hit_triangle(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const Vec2 a = ray.project(vertices[0]);
  const Vec2 b = ray.project(vertices[1]);
  const Vec2 c = ray.project(vertices[2]);
  const float u = edge_area(c, b), v = edge_area(a, c), w = edge_area(b, a);

  // Bound on the error of u, v and w. With coordinates of size s, off by 8 r (r = reach_error):
  // 2 (8 r) s + 2 (8 r)^2 from the coordinates, 2 s^2 x 2^-24 from the products and their
  // difference; rounded up. The last term covers what underflows.
  const float size = std::max({std::abs(a.x) + std::abs(a.y), std::abs(b.x) + std::abs(b.y),
                               std::abs(c.x) + std::abs(c.y)});
  const float r = ray.reach_error;
  const float bound = (18.0f * r + 4.0f * unit_roundoff * size) * size + 160.0f * r * r + 0x1p-120f;

  const float least = std::min({u, v, w}), most = std::max({u, v, w});
  if (least < -bound && most > bound) return no_hit;
  if (!(least > bound || most < -bound)) return hit_triangle_exactly(ray, vertices, sides);
  return hit_triangle_plane(ray, vertices, sides);
}

/// A box around the part of a triangle in `cell`, or a little larger: around what lies between each
/// two opposite faces of the cell. `whole`: of the vertices. Empty only where that part is.
Aabb clip_triangle(const Vec3* vertices, const Aabb& whole, const Aabb& cell);

/// Weights of the second and third vertex where a ray that hits a triangle does, in double; they
/// are kept within the triangle.
Vec2 triangle_weights(const Ray& ray, const Vec3* vertices);

/// hit_triangle in double throughout (Moeller & Trumbore 1997): the reference picture's test.
double hit_triangle_double(const RayQuery& ray, const Vec3* vertices, Sides sides);

}  // namespace bspview
