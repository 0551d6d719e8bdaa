#pragma once

#include <optional>

#include "core/shape/triangle.h"

namespace bspview {

/// hit_triangle_plane where double decides it, as nearly always; else nothing. AnyRay: a RayQuery,
/// or what has its wide_origin, wide_direction, t_min and t_max.
template <class AnyRay>
inline std::optional<double> hit_triangle_plane_in_double(const AnyRay& ray, const Vec3* vertices,
                                                          Sides sides) {
  const Vec3d edge1 = Vec3d(vertices[1]) - Vec3d(vertices[0]);
  const Vec3d edge2 = Vec3d(vertices[2]) - Vec3d(vertices[0]);
  const Vec3d way = Vec3d(vertices[0]) - ray.wide_origin;
  const Vec3d normal = glm::cross(edge1, edge2);
  const double slope = glm::dot(normal, ray.wide_direction);
  const double height = glm::dot(normal, way);

  // Both are off by less than 2^-49 of the product of the sizes: where neither is below 2^-25 of
  // it, t is right to 2^-23.
  const double area_size = sum_of_magnitudes(edge1) * sum_of_magnitudes(edge2);
  const double height_size = area_size * sum_of_magnitudes(way);
  const bool slope_is_open =
      std::abs(slope) < 0x1p-25 * area_size * sum_of_magnitudes(ray.wide_direction);
  if (slope_is_open || std::abs(height) < 0x1p-25 * height_size) {
    // Nearly every ray that leaves the triangle: it is surely behind its origin.
    const bool is_behind = !slope_is_open && (height < 0.0) != (slope < 0.0) &&
                           std::abs(height) > 0x1p-48 * height_size;
    if (is_behind && ray.t_min >= 0.0) return no_hit;
    return std::nullopt;
  }
  const double t = height / slope;
  const bool accepted = ray.t_min < t && t < ray.t_max;
  return accepted && !(sides == Sides::front && slope > 0.0) ? t : no_hit;
}

}  // namespace bspview
