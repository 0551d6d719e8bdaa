// After Sutherland & Hodgman 1974, "Reentrant polygon clipping".

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shape/outline.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include <algorithm>

#include "core/math/float_lanes-inl.h"
#include "core/math/largest_coordinate.h"
#include "core/shape/outline.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {
namespace {

using Corner = OutlineCorner;
using Doubles = hn::CappedTag<double, 4>;
using Floats = hn::Rebind<float, Doubles>;
constexpr Doubles doubles;
constexpr Floats floats;

HWY_INLINE void write(const Corner& p, Corner& to) {
  for (std::size_t i = 0; i < 4; i += hn::Lanes(doubles)) {
    hn::StoreU(hn::LoadU(doubles, &p[i]), doubles, &to[i]);
  }
}

/// The point at a share of the way from p to q.
HWY_INLINE void write_crossing(const Corner& p, const Corner& q, double share, Corner& to) {
  const auto shares = hn::Set(doubles, share);
  for (std::size_t i = 0; i < 4; i += hn::Lanes(doubles)) {
    const auto from = hn::LoadU(doubles, &p[i]), way = hn::Sub(hn::LoadU(doubles, &q[i]), from);
    hn::StoreU(hn::Add(from, hn::Mul(shares, way)), doubles, &to[i]);
  }
}

struct BoxLanes {
  hn::Vec<Floats> lo, hi;
};

/// The box of corners, moved outwards by `margin`, in the lanes from `lane` on.
HWY_INLINE BoxLanes box_around(Outline part, double margin, std::size_t lane) {
  const auto at = [&](std::size_t i) { return hn::LoadU(doubles, &part[i][lane]); };
  const std::size_t last = part.size() - 1;
  auto low = at(0), high = low;
  // Most outlines have about so many: to look at some corners twice is faster than to guess wrong.
  constexpr std::size_t few = 6;
  for (std::size_t i = 1; i < few; ++i) {
    const auto corner = at(std::min(i, last));
    low = hn::Min(low, corner);
    high = hn::Max(high, corner);
  }
  for (std::size_t i = few; i <= last; ++i) {
    low = hn::Min(low, at(i));
    high = hn::Max(high, at(i));
  }
  const auto more = hn::Set(doubles, margin);
  return {round_to_float<-1>(doubles, hn::Sub(low, more)),
          round_to_float<1>(doubles, hn::Add(high, more))};
}

/// Writes the box of a side, of which one limit is the plane: `way` is 1 to the right of it. False
/// when it is empty.
template <int way>
HWY_INLINE bool find_side_box(Outline side, const LaneBox& whole, const OutlineCut& cut,
                              LaneBox& box) {
  if (side.empty()) return false;
  bool is_box = true;
  const auto plane = hn::Set(floats, cut.position);
  for (std::size_t i = 0; i < 4; i += hn::Lanes(floats)) {
    const auto lane = hn::Iota(floats, static_cast<float>(i));
    const auto across = hn::Eq(lane, hn::Set(floats, static_cast<float>(cut.axis)));
    const auto whole_lo = hn::LoadU(floats, whole.lo + i),
               whole_hi = hn::LoadU(floats, whole.hi + i);
    const BoxLanes around = box_around(side, cut.margin, i);
    const auto lo =
        hn::Max(around.lo, way > 0 ? hn::IfThenElse(across, plane, whole_lo) : whole_lo);
    const auto least =
        hn::Min(around.hi, way < 0 ? hn::IfThenElse(across, plane, whole_hi) : whole_hi);
    const auto hi = hn::IfThenElse(hn::Eq(lane, hn::Set(floats, 3.0f)), whole_hi, least);
    hn::StoreU(lo, floats, box.lo + i);
    hn::StoreU(hi, floats, box.hi + i);
    is_box &= hn::AllTrue(floats, hn::Le(lo, hi));
  }
  return is_box;
}

OutlineSides divide_outline(Outline part, const LaneBox& box, const OutlineCut& cut, Corner* to,
                            const LaneBoxes& boxes) {
  if (part.empty()) return {};
  const auto axis = static_cast<std::size_t>(cut.axis);
  const double position = cut.position, margin = cut.margin;
  Corner* const first_left = to;
  Corner* const first_right = to + outline_room(part.size());
  Corner *left = first_left, *right = first_right;
  const Corner* p = &part.back();
  double p_height = (*p)[axis] - position;
  bool p_left = p_height <= margin, p_right = p_height >= -margin;
  for (const Corner& q : part) {
    const double height = q[axis] - position;
    const bool is_left = height <= margin, is_right = height >= -margin;
    if ((is_left != p_left) | (is_right != p_right)) {
      const double fall = p_height - height;
      write_crossing(*p, q, (p_height - margin) / fall, *left);
      write_crossing(*p, q, (p_height + margin) / fall, *right);
      left += is_left != p_left;
      right += is_right != p_right;
    }
    write(q, *left);
    write(q, *right);
    left += is_left;
    right += is_right;
    p = &q;
    p_height = height;
    p_left = is_left;
    p_right = is_right;
  }
  OutlineSides sides{{first_left, left}, {first_right, right}};
  if (!find_side_box<-1>(sides.left, box, cut, boxes.left)) sides.left = {};
  if (!find_side_box<1>(sides.right, box, cut, boxes.right)) sides.right = {};
  return sides;
}

Aabb box_of_outline(Outline part, double margin) {
  if (part.empty()) return {};
  LaneBox box;
  for (std::size_t i = 0; i < 4; i += hn::Lanes(floats)) {
    const BoxLanes around = box_around(part, margin, i);
    hn::StoreU(around.lo, floats, box.lo + i);
    hn::StoreU(around.hi, floats, box.hi + i);
  }
  return aabb(box);
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(divide_outline);
HWY_EXPORT(box_of_outline);

double outline_margin(const Aabb& box) {
  return 0x1p-43 * largest_coordinate(box);
}

OutlineSides divide(Outline part, const LaneBox& box, const OutlineCut& cut, OutlineCorner* to,
                    const LaneBoxes& boxes) {
  return HWY_DYNAMIC_DISPATCH(divide_outline)(part, box, cut, to, boxes);
}

Aabb box_of(Outline part, double margin) {
  return HWY_DYNAMIC_DISPATCH(box_of_outline)(part, margin);
}

}  // namespace bspview
#endif
