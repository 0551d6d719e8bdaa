// After Sutherland & Hodgman 1974, "Reentrant polygon clipping".

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shape/outline.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include <utility>

#include "core/math/float_lanes-inl.h"
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

/// Writes the box of the corners, moved outwards by `margin` and cut off by `bounds`.
HWY_INLINE void find_box(Outline part, double margin, const LaneBox& bounds, LaneBox& box) {
  const auto more = hn::Set(doubles, margin);
  for (std::size_t i = 0; i < 4; i += hn::Lanes(doubles)) {
    auto low = hn::LoadU(doubles, &part[0][i]), high = low;
    for (const Corner& corner : part.subspan(1)) {
      const auto at = hn::LoadU(doubles, &corner[i]);
      low = hn::Min(low, at);
      high = hn::Max(high, at);
    }
    const auto lo = round_to_float<-1>(doubles, hn::Sub(low, more));
    const auto hi = round_to_float<1>(doubles, hn::Add(high, more));
    hn::StoreU(hn::Max(lo, hn::LoadU(floats, bounds.lo + i)), floats, box.lo + i);
    hn::StoreU(hn::Min(hi, hn::LoadU(floats, bounds.hi + i)), floats, box.hi + i);
  }
}

/// Writes the box of a side within `bounds`, of which one limit is the plane.
HWY_INLINE void find_side_box(const LaneBox& bounds, float& limit, const OutlineCut& cut,
                              OutlineSide& side) {
  if (side.outline.empty()) return;
  const float whole = std::exchange(limit, cut.position);
  find_box(side.outline, cut.margin, bounds, side.box);
  limit = whole;
  const LaneBox& box = side.box;
  const bool is_box =
      (box.lo[0] <= box.hi[0]) & (box.lo[1] <= box.hi[1]) & (box.lo[2] <= box.hi[2]);
  if (!is_box) side.outline = {};
}

void divide_outline(Outline part, const LaneBox& box, const OutlineCut& cut, Corner* to,
                    OutlineSides& sides) {
  sides.left.outline = sides.right.outline = {};
  if (part.empty()) return;
  const auto axis = static_cast<std::size_t>(cut.axis);
  const double position = cut.position, margin = cut.margin;
  Corner* const left = to;
  Corner* const right = to + outline_room(part.size());
  std::size_t left_size = 0, right_size = 0;
  const Corner* p = &part.back();
  double p_height = (*p)[axis] - position;
  bool p_left = p_height <= margin, p_right = p_height >= -margin;
  for (const Corner& q : part) {
    const double height = q[axis] - position;
    const bool is_left = height <= margin, is_right = height >= -margin;
    if ((is_left != p_left) | (is_right != p_right)) {
      const double fall = p_height - height;
      write_crossing(*p, q, (p_height - margin) / fall, left[left_size]);
      write_crossing(*p, q, (p_height + margin) / fall, right[right_size]);
      left_size += is_left != p_left;
      right_size += is_right != p_right;
    }
    write(q, left[left_size]);
    write(q, right[right_size]);
    left_size += is_left;
    right_size += is_right;
    p = &q;
    p_height = height;
    p_left = is_left;
    p_right = is_right;
  }
  sides.left.outline = {left, left_size};
  sides.right.outline = {right, right_size};
  LaneBox bounds = box;
  find_side_box(bounds, bounds.hi[axis], cut, sides.left);
  find_side_box(bounds, bounds.lo[axis], cut, sides.right);
}

Aabb box_of_outline(Outline part, double margin) {
  if (part.empty()) return {};
  constexpr float most = std::numeric_limits<float>::infinity();
  constexpr LaneBox everything{{-most, -most, -most, -most}, {most, most, most, most}};
  LaneBox box;
  find_box(part, margin, everything, box);
  return {{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}};
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(divide_outline);
HWY_EXPORT(box_of_outline);

double outline_margin(const Aabb& box) {
  return 0x1p-43 * largest_component(glm::max(magnitudes(box.lo), magnitudes(box.hi)));
}

void divide(Outline part, const LaneBox& box, const OutlineCut& cut, OutlineCorner* to,
            OutlineSides& sides) {
  HWY_DYNAMIC_DISPATCH(divide_outline)(part, box, cut, to, sides);
}

Aabb box_of(Outline part, double margin) {
  return HWY_DYNAMIC_DISPATCH(box_of_outline)(part, margin);
}

}  // namespace bspview
#endif
