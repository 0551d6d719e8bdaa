#include "core/bsp/cost.h"

#include <algorithm>

namespace bspview {
namespace {

double at_least_zero(float x) {
  return x > 0.0f ? x : 0.0;
}

Vec3d extent_in_double(const Aabb& box) {
  return Vec3d(box.hi) - Vec3d(box.lo);
}

double half_area_in_double(const Vec3d& d) {
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

}  // namespace

CostModel cost_model(const BuildParams& params, float cost_intersection) {
  return {.traversal = at_least_zero(params.cost_traversal),
          .intersection = at_least_zero(params.cost_intersection.value_or(cost_intersection)),
          .empty_factor = 1.0 - std::min(1.0, at_least_zero(params.empty_bonus))};
}

SplitTests::SplitTests(const CostModel& model, const Aabb& cell, int axis)
    : lo(cell.lo[axis]),
      hi(cell.hi[axis]),
      empty_factor(model.empty_factor),
      counts_all(model.counts_all) {
  const Vec3d d = extent_in_double(cell);
  const double u = d[(axis + 1) % 3];
  const double v = d[(axis + 2) % 3];
  const double area = half_area_in_double(d);
  // A cell without area is a line: its parts are crossed in the ratio of their lengths.
  caps = area > 0.0 ? u * v / area : 0.0;
  rim = area > 0.0 ? (u + v) / area : 1.0 / d[axis];
}

double crossing_probability(const Aabb& part, const Aabb& cell) {
  if (cell.empty()) return 1.0;
  const Vec3d whole = extent_in_double(cell);
  const Vec3d some = extent_in_double(part);
  const double area = half_area_in_double(whole);
  if (area > 0.0) return half_area_in_double(some) / area;
  const double length = whole.x + whole.y + whole.z;
  return length > 0.0 ? (some.x + some.y + some.z) / length : 1.0;
}

}  // namespace bspview
