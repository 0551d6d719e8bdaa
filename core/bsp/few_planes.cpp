#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bsp/few_planes.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include "core/bsp/few_planes.h"
#include "core/math/float_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {
namespace {

// Lanes: x, y, z, and one that counts for nothing.
constexpr std::size_t axis_lanes = 4;
using Doubles = hn::CappedTag<double, axis_lanes>;
using Floats = hn::CappedTag<float, 2 * axis_lanes>;
using Ints = hn::RebindToSigned<Floats>;
using DoubleV = hn::Vec<Doubles>;
using FloatV = hn::Vec<Floats>;
using IntV = hn::Vec<Ints>;
constexpr Doubles doubles;
constexpr Floats floats;
constexpr Ints ints;

/// Of the planes across each axis.
struct alignas(32) AxisCosts {
  double lo[axis_lanes], hi[axis_lanes], caps[axis_lanes], rim[axis_lanes];
  double first[axis_lanes], last[axis_lanes];
};

/// The planes to try, and how many boxes touch each side of them.
struct alignas(32) Planes {
  static constexpr std::size_t most = (2 * most_few_parts + 2) * axis_lanes;

  float position[most];
  std::int32_t left[most], right[most];
};

AxisCosts axis_costs(const BuildJob& job, const Aabb& cell) {
  AxisCosts costs;
  for (int axis = 0; axis < 3; ++axis) {
    const SplitCost cost(job.costs, cell, axis);
    costs.lo[axis] = cost.lo;
    costs.hi[axis] = cost.hi;
    costs.caps[axis] = cost.caps;
    costs.rim[axis] = cost.rim;
    const PlaneRange range(job, cell, axis);
    costs.first[axis] = range.first();
    costs.last[axis] = range.last();
  }
  costs.lo[3] = costs.hi[3] = costs.caps[3] = costs.rim[3] = 0.0;
  costs.first[3] = 1.0;
  costs.last[3] = 0.0;  // no room
  return costs;
}

/// The last ones are the first and the last plane for which there is room.
HWY_INLINE void place_planes(std::span<const FewBox> boxes, const AxisCosts& costs,
                             float* positions) {
  alignas(32) static constexpr std::int32_t outwards[2 * axis_lanes] = {-1, -1, -1, -1, 1, 1, 1, 1};
  for (const FewBox& box : boxes) {
    for (std::size_t lane = 0; lane < 2 * axis_lanes; lane += hn::Lanes(floats)) {
      const FloatV sides = hn::Load(floats, box.lo + lane);
      hn::Store(next_float(floats, sides, hn::Load(ints, outwards + lane)), floats,
                positions + lane);
    }
    positions += 2 * axis_lanes;
  }
  for (std::size_t lane = 0; lane < axis_lanes; ++lane) {
    positions[lane] = static_cast<float>(costs.first[lane]);
    positions[axis_lanes + lane] = static_cast<float>(costs.last[lane]);
  }
}

HWY_INLINE void count_sides(std::span<const FewBox> boxes, Planes& planes, std::size_t count) {
  for (std::size_t plane = 0; plane < count; plane += hn::Lanes(floats)) {
    const FloatV position = hn::Load(floats, planes.position + plane);
    IntV left = hn::Zero(ints), right = hn::Zero(ints);
    for (const FewBox& box : boxes) {
      const FloatV lo = hn::LoadDup128(floats, box.lo), hi = hn::LoadDup128(floats, box.hi);
      left = hn::Sub(left, hn::VecFromMask(ints, hn::RebindMask(ints, hn::Le(lo, position))));
      right = hn::Sub(right, hn::VecFromMask(ints, hn::RebindMask(ints, hn::Ge(hi, position))));
    }
    hn::Store(left, ints, planes.left + plane);
    hn::Store(right, ints, planes.right + plane);
  }
}

/// The cheapest plane of each axis.
struct alignas(32) AxisBests {
  double cost[axis_lanes], position[axis_lanes];
};

/// Costs as those of SplitCost.
HWY_INLINE void find_cheapest(const CostModel& model, const AxisCosts& costs, const Planes& planes,
                              std::size_t count, AxisBests& bests) {
  const hn::Rebind<float, Doubles> narrow;
  const hn::Rebind<std::int32_t, Doubles> narrow_ints;
  const DoubleV traversal = hn::Set(doubles, model.traversal);
  const DoubleV empty_factor = hn::Set(doubles, model.empty_factor);
  for (std::size_t lane = 0; lane < axis_lanes; lane += hn::Lanes(doubles)) {
    const DoubleV lo = hn::Load(doubles, costs.lo + lane), hi = hn::Load(doubles, costs.hi + lane);
    const DoubleV caps = hn::Load(doubles, costs.caps + lane);
    const DoubleV rim = hn::Load(doubles, costs.rim + lane);
    const DoubleV first = hn::Load(doubles, costs.first + lane);
    const DoubleV last = hn::Load(doubles, costs.last + lane);
    DoubleV best_cost = hn::Set(doubles, std::numeric_limits<double>::infinity());
    DoubleV best_position = hn::Zero(doubles);
    for (std::size_t plane = lane; plane < count; plane += axis_lanes) {
      const DoubleV position = hn::PromoteTo(doubles, hn::Load(narrow, planes.position + plane));
      const DoubleV left = hn::PromoteTo(doubles, hn::Load(narrow_ints, planes.left + plane));
      const DoubleV right = hn::PromoteTo(doubles, hn::Load(narrow_ints, planes.right + plane));
      const DoubleV before = hn::Add(caps, hn::Mul(rim, hn::Sub(position, lo)));
      const DoubleV behind = hn::Add(caps, hn::Mul(rim, hn::Sub(hi, position)));
      const DoubleV tests = hn::Add(hn::Mul(left, before), hn::Mul(right, behind));
      const DoubleV full = hn::Add(traversal, tests);
      const auto empty = hn::Eq(hn::Min(left, right), hn::Zero(doubles));
      const DoubleV cost = hn::IfThenElse(empty, hn::Mul(full, empty_factor), full);
      const auto has_room = hn::And(hn::Le(first, position), hn::Le(position, last));
      const auto tie = hn::And(hn::Eq(cost, best_cost), hn::Lt(position, best_position));
      const auto better = hn::And(has_room, hn::Or(hn::Lt(cost, best_cost), tie));
      best_cost = hn::IfThenElse(better, cost, best_cost);
      best_position = hn::IfThenElse(better, position, best_position);
    }
    hn::Store(best_cost, doubles, bests.cost + lane);
    hn::Store(best_position, doubles, bests.position + lane);
  }
}

Split cheapest_plane(const BuildJob& job, std::span<const FewBox> boxes, const Aabb& cell) {
  const AxisCosts costs = axis_costs(job, cell);
  const std::size_t count = (2 * boxes.size() + 2) * axis_lanes;
  Planes planes;
  place_planes(boxes, costs, planes.position);
  count_sides(boxes, planes, count);
  AxisBests bests;
  find_cheapest(job.costs, costs, planes, count, bests);
  int axis = bests.cost[1] < bests.cost[0] ? 1 : 0;
  axis = bests.cost[2] < bests.cost[axis] ? 2 : axis;
  return {
      .axis = axis, .position = static_cast<float>(bests.position[axis]), .cost = bests.cost[axis]};
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(cheapest_plane);

Split cheapest_of_few(const BuildJob& job, std::span<const FewBox> boxes, const Aabb& cell) {
  return HWY_DYNAMIC_DISPATCH(cheapest_plane)(job, boxes, cell);
}

}  // namespace bspview
#endif
