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
constexpr Doubles doubles;
constexpr Floats floats;
constexpr Ints ints;
constexpr hn::Rebind<float, Doubles> narrow;

/// As of SplitTests and PlaneRange.
struct alignas(32) Axes {
  double lo[axis_lanes], hi[axis_lanes], caps[axis_lanes], rim[axis_lanes];
  float first[axis_lanes], last[axis_lanes];  // one behind the other
};

/// The planes to try, and what testing the boxes that touch each side of them costs.
struct alignas(32) Planes {
  static constexpr std::size_t most = (2 * most_few_parts + 2) * axis_lanes;

  float position[most];
  float left[most], right[most];
  double tests[most];
};

/// One number an axis, and `rest`, in the lanes from `lane` on. Through memory it would take
/// longer.
HWY_INLINE DoubleV by_axis(const Vec3d& numbers, std::size_t lane, double rest = 0.0) {
  const DoubleV index = hn::Iota(doubles, static_cast<double>(lane));
  const auto is = [&](double axis) { return hn::Eq(index, hn::Set(doubles, axis)); };
  const DoubleV z = hn::IfThenElse(is(2.0), hn::Set(doubles, numbers.z), hn::Set(doubles, rest));
  const DoubleV y = hn::IfThenElse(is(1.0), hn::Set(doubles, numbers.y), z);
  return hn::IfThenElse(is(0.0), hn::Set(doubles, numbers.x), y);
}

/// The fourth lane has no room for planes.
HWY_INLINE void find_axes(const BuildJob& job, const Aabb& cell, Axes& axes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vec3d from(cell.lo), to(cell.hi), d = to - from;
  const double area = d.x * d.y + d.y * d.z + d.z * d.x;
  const DoubleV areas = hn::Set(doubles, area), width = hn::Set(doubles, job.min_width);
  for (std::size_t lane = 0; lane < axis_lanes; lane += hn::Lanes(doubles)) {
    const DoubleV lo = by_axis(from, lane, infinity), hi = by_axis(to, lane, -infinity);
    const DoubleV u = by_axis({d.y, d.z, d.x}, lane), v = by_axis({d.z, d.x, d.y}, lane);
    hn::Store(lo, doubles, axes.lo + lane);
    hn::Store(hi, doubles, axes.hi + lane);
    hn::Store(hn::Div(hn::Mul(u, v), areas), doubles, axes.caps + lane);
    hn::Store(hn::Div(hn::Add(u, v), areas), doubles, axes.rim + lane);
    hn::Store(round_to_float<1>(doubles, hn::Add(lo, width)), narrow, axes.first + lane);
    hn::Store(round_to_float<-1>(doubles, hn::Sub(hi, width)), narrow, axes.last + lane);
  }
  if (area > 0.0) return;
  for (int axis = 0; axis < 3; ++axis) {
    const SplitTests tests(job.costs, cell, axis);
    axes.caps[axis] = tests.caps;
    axes.rim[axis] = tests.rim;
  }
}

/// The last ones are the first and the last plane for which there is room. False where every box
/// reaches across all planes.
template <std::size_t extent>
HWY_INLINE bool place_planes(std::span<const FewBox, extent> boxes, const Axes& axes,
                             float* positions) {
  alignas(32) static constexpr std::int32_t outwards[2 * axis_lanes] = {-1, -1, -1, -1, 1, 1, 1, 1};
  alignas(32) static constexpr float signs[2 * axis_lanes] = {0,     0,     0,     0,
                                                              -0.0f, -0.0f, -0.0f, -0.0f};
  bool all_cross = true;
  for (std::size_t lane = 0; lane < 2 * axis_lanes; lane += hn::Lanes(floats)) {
    const auto way = hn::Load(ints, outwards + lane);
    const FloatV sign = hn::Load(floats, signs + lane);
    FloatV innermost = hn::Set(floats, -std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const FloatV plane = next_float(floats, hn::Load(floats, boxes[i].lo + lane), way);
      innermost = hn::Max(innermost, hn::Xor(plane, sign));
      hn::Store(plane, floats, positions + 2 * axis_lanes * i + lane);
    }
    const FloatV limit = hn::Load(floats, axes.first + lane);
    all_cross &= hn::AllTrue(floats, hn::Lt(innermost, hn::Xor(limit, sign)));
    hn::Store(limit, floats, positions + 2 * axis_lanes * boxes.size() + lane);
  }
  return !all_cross;
}

template <std::size_t extent>
HWY_INLINE void add_up_sides(std::span<const FewBox, extent> boxes, Planes& planes,
                             std::size_t count) {
  for (std::size_t plane = 0; plane < count; plane += hn::Lanes(floats)) {
    const FloatV position = hn::Load(floats, planes.position + plane);
    FloatV left = hn::Zero(floats), right = hn::Zero(floats);
    for (const FewBox& box : boxes) {
      // One lane alone stands for one axis.
      const FloatV lo = hn::LoadDup128(floats, box.lo + plane % axis_lanes);
      const FloatV hi = hn::LoadDup128(floats, box.hi + plane % axis_lanes);
      const FloatV tests = hn::Set(floats, box.tests());
      left = hn::Add(left, hn::IfThenElseZero(hn::Le(lo, position), tests));
      right = hn::Add(right, hn::IfThenElseZero(hn::Ge(hi, position), tests));
    }
    hn::Store(left, floats, planes.left + plane);
    hn::Store(right, floats, planes.right + plane);
  }
}

/// Of the planes across each axis: the fewest expected tests, and the lowest plane of as many.
struct alignas(32) AxisBests {
  double tests[axis_lanes], position[axis_lanes];
};

/// Of the planes of the axes from `lane` on; where there is no room, they are infinitely many.
HWY_INLINE void find_bests(double empty_factor, const Axes& axes, Planes& planes, std::size_t count,
                           std::size_t lane, AxisBests& bests) {
  const auto load = [&](const double* each) { return hn::Load(doubles, each + lane); };
  const auto load_wide = [&](const float* each) {
    return hn::PromoteTo(doubles, hn::Load(narrow, each + lane));
  };
  const DoubleV lo = load(axes.lo), hi = load(axes.hi);
  const DoubleV caps = load(axes.caps), rim = load(axes.rim);
  const DoubleV first = load_wide(axes.first), last = load_wide(axes.last);
  const DoubleV factor = hn::Set(doubles, empty_factor);
  const DoubleV infinity = hn::Set(doubles, std::numeric_limits<double>::infinity());
  DoubleV least = infinity;
  for (std::size_t plane = 0; plane < count; plane += axis_lanes) {
    const DoubleV position = load_wide(planes.position + plane);
    const DoubleV left = load_wide(planes.left + plane), right = load_wide(planes.right + plane);
    const DoubleV before = hn::Add(caps, hn::Mul(rim, hn::Sub(position, lo)));
    const DoubleV behind = hn::Add(caps, hn::Mul(rim, hn::Sub(hi, position)));
    const DoubleV tests = hn::Add(hn::Mul(left, before), hn::Mul(right, behind));
    const auto empty = hn::Eq(hn::Min(left, right), hn::Zero(doubles));
    const DoubleV expected = hn::IfThenElse(empty, hn::Mul(tests, factor), tests);
    const auto has_room = hn::And(hn::Le(first, position), hn::Le(position, last));
    const DoubleV allowed = hn::IfThenElse(has_room, expected, infinity);
    hn::Store(allowed, doubles, planes.tests + plane + lane);
    least = hn::Min(allowed, least);
  }
  // Among equals: once more, since each step that looked at both would wait for the one before.
  DoubleV lowest = infinity;
  for (std::size_t plane = 0; plane < count; plane += axis_lanes) {
    const auto is_least = hn::Eq(hn::Load(doubles, planes.tests + plane + lane), least);
    const DoubleV position = load_wide(planes.position + plane);
    lowest = hn::Min(hn::IfThenElse(is_least, position, infinity), lowest);
  }
  hn::Store(least, doubles, bests.tests + lane);
  hn::Store(lowest, doubles, bests.position + lane);
}

/// Whether a plane that all boxes reach across saves too little, whatever is rounded.
template <std::size_t extent>
HWY_INLINE bool cannot_pay(const CostModel& costs, std::span<const FewBox, extent> boxes) {
  double tests = 0.0;
  for (const FewBox& box : boxes) tests += box.tests();
  return costs.traversal > 1e-5 * costs.intersection * tests;
}

template <std::size_t extent>
HWY_INLINE Split find_cheapest(const BuildJob& job, std::span<const FewBox, extent> boxes,
                               const Aabb& cell) {
  Axes axes;
  find_axes(job, cell, axes);
  Planes planes;
  if (!place_planes(boxes, axes, planes.position) && cannot_pay(job.costs, boxes)) {
    return {.tests = std::numeric_limits<double>::infinity()};
  }
  const std::size_t count = (2 * boxes.size() + 2) * axis_lanes;
  add_up_sides(boxes, planes, count);
  AxisBests bests;
  for (std::size_t lane = 0; lane < axis_lanes; lane += hn::Lanes(doubles)) {
    find_bests(job.costs.empty_factor, axes, planes, count, lane, bests);
  }
  int axis = bests.tests[1] < bests.tests[0] ? 1 : 0;
  axis = bests.tests[2] < bests.tests[axis] ? 2 : axis;
  return {.axis = axis,
          .position = static_cast<float>(bests.position[axis]),
          .tests = bests.tests[axis]};
}

/// Most nodes hold so few boxes that loops of a fixed length pay.
Split cheapest_plane(const BuildJob& job, std::span<const FewBox> boxes, const Aabb& cell) {
  switch (boxes.size()) {
    case 2:
      return find_cheapest(job, boxes.first<2>(), cell);
    case 3:
      return find_cheapest(job, boxes.first<3>(), cell);
    case 4:
      return find_cheapest(job, boxes.first<4>(), cell);
    default:
      return find_cheapest(job, boxes, cell);
  }
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
