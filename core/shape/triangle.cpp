#include "core/shape/triangle.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/math/exact.h"
#include "core/math/float_error.h"
#include "core/math/largest_coordinate.h"

namespace bspview {
namespace {

/// Sums of the magnitudes of the products that the cross product subtracts.
Vec3d size_of_cross(Vec3d a, Vec3d b) {
  const Vec3d p = magnitudes(a), q = magnitudes(b);
  return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

/// hit_triangle_plane where double decides it, as nearly always; else nothing.
std::optional<double> hit_triangle_plane_in_double(const RayQuery& ray, const Vec3* vertices,
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

/// The slow half of hit_triangle_plane, for rays along the plane and those that start next to it,
/// as all do that leave the triangle: with the roundings that happen instead of those that could,
/// and exactly where these are too large.
double hit_plane_beside(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const Vec3d edge1 = Vec3d(vertices[1]) - Vec3d(vertices[0]);
  const Vec3d edge2 = Vec3d(vertices[2]) - Vec3d(vertices[0]);
  const Vec3d way = Vec3d(vertices[0]) - ray.wide_origin;
  const Vec3d normal = glm::cross(edge1, edge2), normal_size = size_of_cross(edge1, edge2);
  const double slope = glm::dot(normal, ray.wide_direction);
  const double height = glm::dot(normal, way);
  const double slope_size = glm::dot(normal_size, magnitudes(ray.wide_direction));
  const double height_size = glm::dot(normal_size, magnitudes(way));
  bool from_behind = slope > 0.0;
  double t = height / slope;
  // Both are off by less than 2^-49 of their sizes.
  const bool slope_is_open = std::abs(slope) < 0x1p-25 * slope_size;
  const bool is_right = !slope_is_open && !(std::abs(height) < 0x1p-25 * height_size);
  if (!is_right) {
    const bool is_behind = t < 0.0 && !slope_is_open && std::abs(height) > 0x1p-48 * height_size;
    if (is_behind && ray.t_min >= 0.0) return no_hit;
    const int sign = exact_slope_sign(ray.direction, vertices);
    if (sign == 0) return no_hit;
    from_behind = sign > 0;
    t = exact_plane_distance(ray.origin, ray.direction, vertices);
  }
  return ray.accepts(t) && !(sides == Sides::front && from_behind) ? t : no_hit;
}

bool is_finite(const Vec3* vertices) {
  const Vec3 zero = 0.0f * (vertices[0] + vertices[1] + vertices[2]);
  return zero == Vec3(0.0f);
}

/// A box in double.
struct WideBox {
  bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
  void grow(const Vec3d& point) {
    lo = glm::min(lo, point);
    hi = glm::max(hi, point);
  }

  Vec3d lo{std::numeric_limits<double>::infinity()};
  Vec3d hi{-std::numeric_limits<double>::infinity()};
};

/// Box of what of a triangle's edges lies between two planes across an axis.
WideBox box_between(const Vec3d* corners, int axis, double lo, double hi) {
  constexpr double hardly_any = 0x1p-800;  // along the planes: all of the edge, or nothing
  WideBox box;
  for (int i = 0; i < 3; ++i) {
    const Vec3d from = corners[i], way = corners[i == 2 ? 0 : i + 1] - from;
    const double per_way = 1.0 / (way[axis] == 0.0 ? hardly_any : way[axis]);
    const double a = (lo - from[axis]) * per_way, b = (hi - from[axis]) * per_way;
    const double first = std::max(0.0, std::min(a, b)), last = std::min(1.0, std::max(a, b));
    if (first > last) continue;
    box.grow(from + first * way);
    box.grow(from + last * way);
  }
  return box;
}

}  // namespace

double hit_triangle_plane(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const std::optional<double> t = hit_triangle_plane_in_double(ray, vertices, sides);
  return t ? *t : hit_plane_beside(ray, vertices, sides);
}

Aabb clip_triangle(const Vec3* vertices, const Aabb& whole, const Aabb& cell) {
  const Aabb overlap = intersection(whole, cell);
  if (overlap.empty() || overlap == whole) return overlap;
  // Points of edges are off by less than 2^-50 of the largest coordinate. Where planes cross them
  // may be off by more, but by less than what the planes are moved outwards for.
  const double margin = 0x1p-48 * double{largest_coordinate(whole)};
  const Vec3d corners[3] = {Vec3d(vertices[0]), Vec3d(vertices[1]), Vec3d(vertices[2])};
  WideBox part{Vec3d(overlap.lo), Vec3d(overlap.hi)};
  for (int axis = 0; axis < 3; ++axis) {
    if (overlap.lo[axis] == whole.lo[axis] && overlap.hi[axis] == whole.hi[axis]) continue;
    const WideBox between =
        box_between(corners, axis, part.lo[axis] - margin, part.hi[axis] + margin);
    part.lo = glm::max(part.lo, between.lo - margin);
    part.hi = glm::min(part.hi, between.hi + margin);
    if (part.empty()) return {};
  }
  Aabb rounded;
  for (int axis = 0; axis < 3; ++axis) {
    rounded.lo[axis] = round_down(part.lo[axis]);
    rounded.hi[axis] = round_up(part.hi[axis]);
  }
  return rounded;
}

Vec2 triangle_weights(const Ray& ray, const Vec3* vertices) {
  const Vec3d edge1 = Vec3d(vertices[1]) - Vec3d(vertices[0]);
  const Vec3d edge2 = Vec3d(vertices[2]) - Vec3d(vertices[0]);
  const Vec3d direction(ray.direction);
  const double slope = glm::dot(glm::cross(edge1, edge2), direction);
  if (slope == 0.0) return Vec2(1.0f / 3.0f);
  const Vec3d moment = glm::cross(Vec3d(vertices[0]) - Vec3d(ray.origin), direction);
  const double u = std::clamp(glm::dot(moment, edge2) / slope, 0.0, 1.0);
  const double v = std::clamp(-glm::dot(moment, edge1) / slope, 0.0, 1.0 - u);
  return {u, v};
}

double hit_triangle_exactly(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  if (!is_finite(vertices)) return no_hit;
  const auto side = [&](int from, int to) {
    return side_of_edge(ray.origin, ray.direction, vertices[from], vertices[to]);
  };
  const int u = side(2, 1), v = side(0, 2), w = side(1, 0);
  const auto [least, most] = std::minmax({u, v, w});
  if (least < 0 && most > 0) return no_hit;
  if (least == 0 && most == 0) return no_hit;

  return hit_triangle_plane(ray, vertices, sides);
}

double hit_triangle_double(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const Vec3d edge1 = Vec3d(vertices[1]) - Vec3d(vertices[0]);
  const Vec3d edge2 = Vec3d(vertices[2]) - Vec3d(vertices[0]);
  const Vec3d from = Vec3d(ray.origin) - Vec3d(vertices[0]);
  const Vec3d p = glm::cross(Vec3d(ray.direction), edge2);
  const double det = glm::dot(edge1, p);  // > 0: seen from the front
  if (det == 0.0 || (sides == Sides::front && det < 0.0)) return no_hit;
  const Vec3d q = glm::cross(from, edge1);
  const double u = glm::dot(from, p) / det;
  const double v = glm::dot(Vec3d(ray.direction), q) / det;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return no_hit;
  const double t = glm::dot(edge2, q) / det;
  if (!ray.accepts(t)) return no_hit;
  return t;
}

}  // namespace bspview
