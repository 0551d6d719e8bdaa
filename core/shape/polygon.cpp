#include "core/shape/polygon.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/math/exact.h"
#include "core/math/float_error.h"
#include "core/math/largest_coordinate.h"
#include "core/shape/heights.h"
#include "core/shape/outline.h"
#include "core/shape/triangle.h"

namespace bspview {
namespace {

Aabb box_of(std::span<const Vec3> vertices) {
  Aabb box;
  for (const Vec3& vertex : vertices) box.grow(vertex);
  return box;
}

/// Whether the ray passes through the polygon: counts the edges that cross the positive x axis of
/// the ray's plane. Exact.
bool encloses_ray(const RayQuery& plain, std::span<const Vec3> vertices) {
  const RayQuery ray({plain.origin, plain.direction});
  const int mirrored = component(ray.direction, ray.kz) > 0.0f ? 1 : -1;
  const auto is_above = [&](const Vec3& vertex) {
    return mirrored * side_of_line(ray.origin, ray.direction, vertex, ray.ky, ray.kz) > 0;
  };
  bool inside = false;
  const Vec3* from = &vertices.back();
  bool from_above = is_above(*from);
  for (const Vec3& to : vertices) {
    const bool to_above = is_above(to);
    if (from_above != to_above) {
      const int side = mirrored * side_of_edge(ray.origin, ray.direction, *from, to);
      if (side == (to_above ? 1 : -1)) inside = !inside;
    }
    from_above = to_above;
    from = &to;
  }
  return inside;
}

/// Where a ray meets the plane of a polygon, on the two axes on which the polygon is widest. It,
/// and the vertices as the ray sees them on the plane, are off by less than `slack` on either.
struct HitPoint {
  double x, y, slack;
};

/// With the largest component of the direction, m, and every vertex within `reach` of the origin on
/// every axis, double takes the height over the plane by less than 2^-48 area x reach, the slope by
/// less than 2^-50 area m, and the point by less than 2^-48 reach off their places. (A point beyond
/// 16 reach is farther from the polygon than any of that.)
HitPoint hit_point(const RayQuery& ray, const PolygonPlane& plane, double t, double per_slope) {
  const double reach = ray.reach_error * 0x1p24;
  const double flatness = std::abs(per_slope * ray.size);
  const double height = plane.thickness + 0x1p-44 * plane.area * reach;
  const bool slope_is_lost = !(flatness * plane.area < 0x1p40);
  return {.x = component(ray.origin, plane.x_axis) + t * component(ray.direction, plane.x_axis),
          .y = component(ray.origin, plane.y_axis) + t * component(ray.direction, plane.y_axis),
          .slack = slope_is_lost ? no_hit : height * flatness + 0x1p-44 * reach};
}

/// Side of `p` on which an edge from below it to above it passes: 1 towards larger x, -1 towards
/// smaller, 0 too close to tell.
int side_of_crossing(const HitPoint& p, const PolygonPlane& plane, const Vec3& below,
                     const Vec3& above) {
  const double ax = component(below, plane.x_axis) - p.x, ay = component(below, plane.y_axis) - p.y;
  const double bx = component(above, plane.x_axis) - p.x, by = component(above, plane.y_axis) - p.y;
  const double side = ax * by - ay * bx;
  const double size = std::abs(ax) + std::abs(bx) + by - ay;
  const double bound = (2.0 * p.slack + 0x1p-50 * size) * size;
  return side > bound ? 1 : side < -bound ? -1 : 0;
}

/// How a polygon lies to a point of its plane.
enum class Place { outside, inside, open };

/// As heights_of, for as few points as are done before it would be called.
Heights heights_of_few(std::span<const Vec3> points, int axis, float height) {
  Heights heights;
  for (std::size_t i = 0; i < points.size(); ++i) {
    heights.add(i, component(points[i], axis) - height);
  }
  return heights;
}

/// Counts the edges that cross the half-line from a point towards larger x; open where a vertex or
/// an edge is too close to tell.
class CrossingCount {
 public:
  CrossingCount(const HitPoint& p, const PolygonPlane& plane, const Vec3& last)
      : p_(p), plane_(plane), y_(static_cast<float>(p.y)), from_(&last) {
    from_below_ = std::signbit(component(last, plane.y_axis) - y_);
  }

  /// The edges to at most Heights::most vertices, each from the one before it.
  void add_edges(std::span<const Vec3> vertices) {
    constexpr std::size_t few = 12;
    const Heights heights = vertices.size() <= few ? heights_of_few(vertices, plane_.y_axis, y_)
                                                   : heights_of(vertices, plane_.y_axis, y_);
    nearest_ = std::min(nearest_, heights.nearest);
    const std::uint64_t all = ~std::uint64_t{0} >> (Heights::most - vertices.size());
    std::uint64_t cross = (heights.below ^ (heights.below << 1 | std::uint64_t{from_below_})) & all;
    for (; cross != 0; cross &= cross - 1) {
      const int i = std::countr_zero(cross);
      const Vec3* const to = vertices.data() + i;
      add_crossing(i == 0 ? *from_ : to[-1], *to, (heights.below >> i & 1) != 0);
    }
    from_ = &vertices.back();
    from_below_ = (heights.below >> (vertices.size() - 1) & 1) != 0;
  }

  Place place() const {
    // Heights are off by the rounding of y, and by less than the 2^-22 of themselves.
    if (open_ || !(nearest_ > 1.001 * p_.slack + 0x1p-22 * std::abs(p_.y))) return Place::open;
    return inside_ ? Place::inside : Place::outside;
  }

 private:
  void add_crossing(const Vec3& from, const Vec3& to, bool falls) {
    const int side =
        falls ? side_of_crossing(p_, plane_, to, from) : side_of_crossing(p_, plane_, from, to);
    open_ |= side == 0;
    inside_ ^= side > 0;
  }

  const HitPoint& p_;
  const PolygonPlane& plane_;
  float y_;
  const Vec3* from_;
  bool from_below_;
  float nearest_ = std::numeric_limits<float>::infinity();
  bool inside_ = false, open_ = false;
};

Place place_of(const HitPoint& p, const PolygonPlane& plane, std::span<const Vec3> vertices) {
  CrossingCount count(p, plane, vertices.back());
  for (; vertices.size() > Heights::most; vertices = vertices.subspan(Heights::most)) {
    count.add_edges(vertices.first(Heights::most));
  }
  count.add_edges(vertices);
  return count.place();
}

/// Where the ray leaves the box of the vertices, but for rounding.
double exit_of_box(const RayQuery& ray, std::span<const Vec3> vertices) {
  const Aabb box = box_of(vertices);
  double exit = no_hit;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.wide_direction[axis];
    if (d == 0.0) continue;
    const double side = d > 0.0 ? box.hi[axis] : box.lo[axis];
    exit = std::min(exit, (side - ray.wide_origin[axis]) / d);
  }
  return exit;
}

}  // namespace

PolygonPlane polygon_plane(std::span<const Vec3> vertices) {
  PolygonPlane plane{Vec3d(0.0), Vec3d(0.0)};
  const Vec3d base(vertices[0]);
  Vec3d p = Vec3d(vertices.back()) - base;
  for (const Vec3& vertex : vertices) {
    const Vec3d q = Vec3d(vertex) - base;
    plane.normal += glm::cross(p, q);
    plane.point += q;
    p = q;
  }
  plane.point = base + plane.point / static_cast<double>(vertices.size());
  const Vec3d size = magnitudes(plane.normal);
  const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  plane.x_axis = z == 0 ? 1 : 0;
  plane.y_axis = z == 2 ? 1 : 2;
  plane.area = size.x + size.y + size.z;
  for (const Vec3& vertex : vertices) {
    const Vec3d arm = Vec3d(vertex) - plane.point;
    const double rounding = 0x1p-48 * glm::dot(size, magnitudes(arm));
    const double height = 1.01 * std::abs(glm::dot(plane.normal, arm));
    plane.thickness = std::max(plane.thickness, height + rounding);
  }
  return plane;
}

double hit_polygon(const RayQuery& ray, std::span<const Vec3> vertices, const PolygonPlane& plane,
                   Sides sides) {
  const double slope = glm::dot(plane.normal, ray.wide_direction);
  if (slope == 0.0 || (sides == Sides::front && slope > 0.0)) return no_hit;
  const double per_slope = 1.0 / slope;
  const double t = glm::dot(plane.normal, plane.point - ray.wide_origin) * per_slope;
  const double passage = plane.thickness * std::abs(per_slope);
  // Vertices that are not finite give no t that is accepted.
  if (!(ray.t_min < t + passage && t - passage < ray.t_max)) return no_hit;
  const Place place = place_of(hit_point(ray, plane, t, per_slope), plane, vertices);
  if (place == Place::outside) return no_hit;
  if (place == Place::open && !encloses_ray(ray, vertices)) return no_hit;
  const bool is_long = passage > longest_passage * std::abs(t);
  const double end = is_long ? std::min(t + passage, exit_of_box(ray, vertices)) : t;
  return ray.accepts(end) ? end : no_hit;
}

Aabb clip_polygon(std::span<const Vec3> vertices, const Aabb& cell) {
  return clip_polygon(vertices, box_of(vertices), cell);
}

Aabb clip_polygon(std::span<const Vec3> vertices, const Aabb& whole, const Aabb& cell) {
  const Aabb overlap = intersection(whole, cell);
  if (overlap.empty()) return Aabb{};

  // Cutting 12 times in double is off by far less than 2^-48 of the largest coordinate.
  const double margin = 0x1p-48 * std::max(largest_coordinate(whole), largest_coordinate(cell));
  if (overlap == whole) return whole;
  OutlineRooms rooms;
  const Outline part = find_outline(vertices, whole, cell, margin, rooms);
  return part.empty() ? Aabb{} : intersection(box_of(part, margin), overlap);
}

/// 1 + the cosine of the angle in which an edge is seen: below this, from the edge itself.
constexpr double on_an_edge = 1e-12;

void mean_value_coordinates(std::span<const Vec3> vertices, Vec3 point, std::span<float> weights) {
  const std::size_t n = vertices.size();
  const Vec3d normal = glm::normalize(polygon_plane(vertices).normal);
  const auto arm = [&](std::size_t i) { return Vec3d(vertices[i % n]) - Vec3d(point); };
  // tan(angle / 2) between two arms, signed: (1 - cos) / sin, as sin / (1 + cos).
  const auto half_tangent = [&](Vec3d p, Vec3d q) {
    return glm::dot(glm::cross(p, q), normal) / (glm::length(p) * glm::length(q) + glm::dot(p, q));
  };
  double sum = 0.0;
  std::vector<double> exact(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d here = arm(i);
    const double length = glm::length(here);
    if (length == 0.0) {
      for (std::size_t k = 0; k < n; ++k) weights[k] = k == i ? 1.0f : 0.0f;
      return;
    }
    const Vec3d next = arm(i + 1);
    const double lengths = length * glm::length(next);
    if (lengths > 0.0 && lengths + glm::dot(here, next) <= on_an_edge * lengths) {
      std::fill(weights.begin(), weights.end(), 0.0f);
      weights[i] = static_cast<float>(glm::length(next) / (length + glm::length(next)));
      weights[(i + 1) % n] = 1.0f - weights[i];
      return;
    }
    exact[i] = (half_tangent(arm(i + n - 1), here) + half_tangent(here, next)) / length;
    sum += exact[i];
  }
  for (std::size_t i = 0; i < n; ++i) weights[i] = static_cast<float>(exact[i] / sum);
}

}  // namespace bspview
