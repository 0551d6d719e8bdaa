#include "core/shape/triangle.h"

#include <algorithm>

#include "core/math/exact.h"

namespace bspview {
namespace {

/// Sum of the magnitudes of the components.
double size_of(Vec3d v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

bool is_finite(const Vec3* vertices) {
  const Vec3 zero = 0.0f * (vertices[0] + vertices[1] + vertices[2]);
  return zero == Vec3(0.0f);
}

}  // namespace

ShapeHit hit_triangle_plane(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const Vec3d edge1 = Vec3d(vertices[1]) - Vec3d(vertices[0]);
  const Vec3d edge2 = Vec3d(vertices[2]) - Vec3d(vertices[0]);
  const Vec3d way = Vec3d(vertices[0]) - Vec3d(ray.origin);
  const Vec3d direction(ray.direction);
  const Vec3d normal = glm::cross(edge1, edge2);
  const double slope = glm::dot(normal, direction);
  const double height = glm::dot(normal, way);
  double t = height / slope;
  bool from_behind = slope > 0.0;

  // Both are off by less than 2^-49 of the product of the sizes: where neither is below 2^-25 of
  // it, t is right to 2^-23.
  const double area_size = size_of(edge1) * size_of(edge2);
  const bool slope_is_open = std::abs(slope) < 0x1p-25 * area_size * size_of(direction);
  const bool height_is_open = std::abs(height) < 0x1p-25 * area_size * size_of(way);
  if (slope_is_open || height_is_open) {
    const int sign = exact_slope_sign(ray.direction, vertices);
    if (sign == 0) return {};
    from_behind = sign > 0;
    t = exact_plane_distance(ray.origin, ray.direction, vertices);
  }
  if (!ray.accepts(t) || (sides == Sides::front && from_behind)) return {};

  // The weights only place a point inside: they are kept within the triangle.
  const Vec3d moment = glm::cross(way, direction);
  const double second = slope == 0.0 ? 1.0 / 3.0 : glm::dot(moment, edge2) / slope;
  const double third = slope == 0.0 ? 1.0 / 3.0 : -glm::dot(moment, edge1) / slope;
  const double u = std::clamp(second, 0.0, 1.0);
  return {t, static_cast<float>(u), static_cast<float>(std::clamp(third, 0.0, 1.0 - u))};
}

ShapeHit hit_triangle_exactly(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  if (!is_finite(vertices)) return {};
  const auto side = [&](int from, int to) {
    return side_of_edge(ray.origin, ray.direction, vertices[from], vertices[to]);
  };
  const int u = side(2, 1), v = side(0, 2), w = side(1, 0);
  const auto [least, most] = std::minmax({u, v, w});
  if (least < 0 && most > 0) return {};
  if (least == 0 && most == 0) return {};

  return hit_triangle_plane(ray, vertices, sides);
}

ShapeHit hit_triangle_double(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const Vec3d edge1 = Vec3d(vertices[1]) - Vec3d(vertices[0]);
  const Vec3d edge2 = Vec3d(vertices[2]) - Vec3d(vertices[0]);
  const Vec3d from = Vec3d(ray.origin) - Vec3d(vertices[0]);
  const Vec3d p = glm::cross(Vec3d(ray.direction), edge2);
  const double det = glm::dot(edge1, p);  // > 0: seen from the front
  if (det == 0.0 || (sides == Sides::front && det < 0.0)) return {};
  const Vec3d q = glm::cross(from, edge1);
  const double u = glm::dot(from, p) / det;
  const double v = glm::dot(Vec3d(ray.direction), q) / det;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return {};
  const double t = glm::dot(edge2, q) / det;
  if (!ray.accepts(t)) return {};
  return {t, static_cast<float>(u), static_cast<float>(v)};
}

}  // namespace bspview
