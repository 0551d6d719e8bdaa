#include "core/shape/cone.h"

#include <algorithm>
#include <cmath>

#include "core/math/float_error.h"

namespace bspview {
namespace {

/// Extent of the circle with normal `axis` and radius 1 along coordinate axis i:
/// sqrt(1 - (axis_i / |axis|)^2). Without a direction, that of every circle.
Vec3d circle_extent(Vec3d axis) {
  const double length2 = glm::dot(axis, axis);
  if (length2 == 0.0) return Vec3d(1.0);
  Vec3d extent;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    extent[i] = std::sqrt((axis[j] * axis[j] + axis[k] * axis[k]) / length2);
  }
  return extent;
}

struct Interval {
  double lo, hi;
  bool empty() const { return !(lo <= hi); }
  /// Keeps the s with constant + slope * s >= 0.
  void keep(double constant, double slope) {
    if (slope > 0.0) lo = std::max(lo, -constant / slope);
    if (slope < 0.0) hi = std::min(hi, -constant / slope);
    if (slope == 0.0 && constant < 0.0) hi = lo - 1.0;
  }
};

/// Box of the circles at axis parameters `s`, rounded outwards.
Aabb bounds_of_part(const Cone& cone, Interval s) {
  const Vec3d base(cone.base);
  const Vec3d axis = Vec3d(cone.apex) - base;
  const Vec3d extent = circle_extent(axis);
  const double base_radius = std::abs(static_cast<double>(cone.base_radius));
  const double growth = std::abs(static_cast<double>(cone.apex_radius)) - base_radius;
  Aabb box;
  for (const double end : {s.lo, s.hi}) {
    // The ends themselves are exact, so that a cone along an axis has a tight box.
    const bool inner = 0.0 < end && end < 1.0;
    const Vec3d centre = inner ? base + end * axis : Vec3d(end == 0.0 ? cone.base : cone.apex);
    const Vec3d reach = (base_radius + end * growth) * extent;
    const Vec3d moved = inner ? magnitudes(base) + magnitudes(axis) : Vec3d(0.0);
    const Vec3d margin = 0x1p-48 * (reach + moved);
    for (int i = 0; i < 3; ++i) {
      box.lo[i] = std::min(box.lo[i], round_down(centre[i] - reach[i] - margin[i]));
      box.hi[i] = std::max(box.hi[i], round_up(centre[i] + reach[i] + margin[i]));
    }
  }
  return box;
}

/// The quadratic a t^2 - 2 b t + c = 0 of a ray and the unbounded cone.
struct Quadratic {
  double a, b, c;
  double discriminant() const { return b * b - a * c; }
};

/// Both roots, the smaller first, for a discriminant that is not negative; false when there is
/// none. A vanishing `a` (the ray runs along a generator) leaves one finite root.
bool solve(const Quadratic& equation, double discriminant, double roots[2]) {
  const auto& [a, b, c] = equation;
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  if (q == 0.0 && a == 0.0) return false;
  roots[0] = a == 0.0 ? no_hit : q / a;
  roots[1] = q == 0.0 ? 0.0 : c / q;
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  return true;
}

}  // namespace

ConeFrame::ConeFrame(const Cone& cone)
    : base(cone.base),
      axis(Vec3d(cone.apex) - Vec3d(cone.base)),
      axis2(glm::dot(axis, axis)),
      per_axis2(1.0 / axis2),
      base_radius(std::abs(static_cast<double>(cone.base_radius))),
      growth(std::abs(static_cast<double>(cone.apex_radius)) - base_radius),
      widest2(std::pow(std::max(base_radius, base_radius + growth), 2)),
      is_inside_out(cone.base_radius < 0.0f || cone.apex_radius < 0.0f) {}

namespace {

/// Whether a ray surely passes the axis farther away than the largest radius, as most do. With
/// n = d x axis their distance is |f . n| / |n|; f . n is off by less than 2^-48 |f| |d| |axis|.
bool passes_far_from_axis(const RayQuery& ray, const ConeFrame& cone, Vec3d from_base) {
  const Vec3d across = glm::cross(ray.wide_direction, cone.axis);
  const double distance = glm::dot(from_base, across);
  const double sizes2 = glm::dot(from_base, from_base) * ray.length2 * cone.axis2;
  return distance * distance >
         (1.0 + 0x1p-12) * cone.widest2 * glm::dot(across, across) + 0x1p-80 * sizes2;
}

}  // namespace

double hit_cone(const RayQuery& ray, const ConeFrame& cone, Sides sides) {
  const Vec3d& d = ray.wide_direction;
  // Move the origin to about the ray's closest point to the middle of the axis: far away the
  // discriminant would be lost in the rounding of b * b.
  const Vec3d from_base = ray.wide_origin - cone.base;
  if (passes_far_from_axis(ray, cone, from_base)) return no_hit;
  const double shift = glm::dot(0.5 * cone.axis - from_base, d) * ray.per_length2;
  const Vec3d f = from_base + shift * d;

  // Along the axis: s = m + t n, 0 at the base and 1 at the apex; across it f_across + t d_across.
  const double m = glm::dot(f, cone.axis) * cone.per_axis2;
  const double n = glm::dot(d, cone.axis) * cone.per_axis2;
  const Vec3d f_across = f - m * cone.axis;
  const Vec3d d_across = d - n * cone.axis;
  const double radius = cone.base_radius + cone.growth * m;
  const double slope = cone.growth * n;
  const Quadratic equation{glm::dot(d_across, d_across) - slope * slope,
                           radius * slope - glm::dot(f_across, d_across),
                           glm::dot(f_across, f_across) - radius * radius};
  const double discriminant = equation.discriminant();
  double roots[2];
  if (!(discriminant >= 0.0) || !solve(equation, discriminant, roots)) return no_hit;

  for (const double root : roots) {
    const double s = m + root * n;
    if (!(0.0 <= s && s <= 1.0) || !ray.accepts(shift + root)) continue;
    if (sides == Sides::front) {
      // Half the derivative of |across|^2 - radius^2 along the ray: < 0 where it enters.
      const bool enters = equation.a * root - equation.b < 0.0;
      if (enters == cone.is_inside_out) continue;
    }
    return shift + root;
  }
  return no_hit;
}

Aabb cone_bounds(const Cone& cone) {
  return bounds_of_part(cone, {0.0, 1.0});
}

Aabb clip_cone(const Cone& cone, const Aabb& cell) {
  const Vec3d base(cone.base);
  const Vec3d axis = Vec3d(cone.apex) - base;
  const Vec3d extent = circle_extent(axis);
  const double base_radius = std::abs(static_cast<double>(cone.base_radius));
  const double growth = std::abs(static_cast<double>(cone.apex_radius)) - base_radius;
  Interval s{0.0, 1.0};
  for (int i = 0; i < 3; ++i) {
    const double margin =
        0x1p-40 * (std::abs(base[i]) + std::abs(axis[i]) + base_radius + std::abs(growth));
    const double widest = base_radius * extent[i] + margin;
    const double widening = growth * extent[i];
    s.keep(base[i] + widest - cell.lo[i], axis[i] + widening);
    s.keep(cell.hi[i] - base[i] + widest, widening - axis[i]);
  }
  if (s.empty()) return Aabb{};
  const Aabb box = intersection(bounds_of_part(cone, s), cell);
  return box.empty() ? Aabb{} : box;
}

Vec3d cone_normal(const Cone& cone, Vec3d point) {
  const Vec3d axis = Vec3d(cone.apex) - Vec3d(cone.base);
  const double axis2 = glm::dot(axis, axis);
  const Vec3d from_base = point - Vec3d(cone.base);
  const Vec3d across = from_base - (glm::dot(from_base, axis) / axis2) * axis;
  const double growth = std::abs(static_cast<double>(cone.apex_radius)) -
                        std::abs(static_cast<double>(cone.base_radius));
  return glm::normalize(glm::normalize(across) - (growth / axis2) * axis);
}

}  // namespace bspview
