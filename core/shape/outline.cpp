// After Sutherland & Hodgman 1974, "Reentrant polygon clipping".

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shape/outline.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include <vector>

#include "core/math/float_lanes-inl.h"
#include "core/shape/outline.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {
namespace {

using Corner = Outline::Corner;
using Doubles = hn::CappedTag<double, 4>;
constexpr Doubles doubles;

/// Corners that are written one after the other; there is room for two more than `most`.
struct CornerWriter {
  Corner* corners;
  std::size_t most;
  std::size_t size = 0;

  /// Where the edge from p to q, with heights of different signs, meets height 0.
  HWY_INLINE void push_crossing(const Corner& p, double p_height, const Corner& q,
                                double q_height) {
    const auto share = hn::Set(doubles, p_height / (p_height - q_height));
    for (std::size_t i = 0; i < 4; i += hn::Lanes(doubles)) {
      const auto from = hn::LoadU(doubles, &p[i]), to = hn::LoadU(doubles, &q[i]);
      const auto at = hn::Add(from, hn::Mul(share, hn::Sub(to, from)));
      hn::StoreU(at, doubles, &corners[size][i]);
    }
    ++size;
  }
  HWY_INLINE void push_if(bool kept, const Corner& p) {
    for (std::size_t i = 0; i < 4; i += hn::Lanes(doubles)) {
      hn::StoreU(hn::LoadU(doubles, &p[i]), doubles, &corners[size][i]);
    }
    size += kept;
  }
  bool full() const { return size > most; }
};

/// Half-space of the points p with sign * p[axis] >= limit.
struct HalfSpace {
  int axis;
  double sign, limit;

  double height(const Corner& p) const { return sign * p[static_cast<std::size_t>(axis)] - limit; }
};

/// The half-spaces that cut a polygon with box `whole` down to `cell`.
struct Cuts {
  std::array<HalfSpace, 6> halves;
  std::size_t count = 0;

  Cuts(const Aabb& whole, const Aabb& cell, double margin) {
    for (int axis = 0; axis < 3; ++axis) {
      const double lo = component(cell.lo, axis), hi = component(cell.hi, axis);
      if (component(whole.lo, axis) < lo) halves[count++] = {axis, 1.0, lo - margin};
      if (component(whole.hi, axis) > hi) halves[count++] = {axis, -1.0, -hi - margin};
    }
  }
  std::span<const HalfSpace> all() const { return std::span(halves).first(count); }
};

/// Writes what is left of the corners; false when that is too much.
HWY_INLINE bool clip(std::span<const Corner> corners, const HalfSpace& half, CornerWriter& to) {
  if (corners.empty()) return true;
  const Corner* p = &corners.back();
  double p_height = half.height(*p);
  for (const Corner& q : corners) {
    const double q_height = half.height(q);
    if ((p_height >= 0.0) != (q_height >= 0.0)) to.push_crossing(*p, p_height, q, q_height);
    to.push_if(q_height >= 0.0, q);
    if (to.full()) return false;
    p = &q;
    p_height = q_height;
  }
  return true;
}

bool divide_outline(const Outline& part, const OutlineCut& cut, const OutlineSides& sides) {
  const std::span corners = std::span(part.corners).first(part.size);
  CornerWriter left{sides.left.corners.data(), Outline::most_corners};
  CornerWriter right{sides.right.corners.data(), Outline::most_corners};
  const bool fits = clip(corners, {cut.axis, -1.0, -cut.position - cut.margin}, left) &&
                    clip(corners, {cut.axis, 1.0, cut.position - cut.margin}, right);
  sides.left.size = left.size;
  sides.right.size = right.size;
  return fits;
}

bool clip_to_cell(std::span<const Vec3> polygon, const Aabb& whole, const Aabb& cell, double margin,
                  Outline& part) {
  std::array<Corner, 2 * (Outline::most_corners + 2)> few;
  std::vector<Corner> many;
  std::size_t most = Outline::most_corners;
  if (polygon.size() > most) {
    most = 2 * polygon.size();
    many.resize(2 * (most + 2));
  }
  Corner* from = many.empty() ? few.data() : many.data();
  Corner* to = from + most + 2;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    from[i] = {polygon[i].x, polygon[i].y, polygon[i].z, 0.0};
  }
  std::size_t size = polygon.size();
  const Cuts cuts(whole, cell, margin);
  for (const HalfSpace& half : cuts.all()) {
    CornerWriter writer{to, most};
    if (!clip({from, size}, half, writer)) return false;
    size = writer.size;
    std::swap(from, to);
  }
  if (size > Outline::most_corners) return false;
  std::copy_n(from, size, part.corners.data());
  part.size = size;
  return true;
}

Aabb box_of_outline(const Outline& part, double margin) {
  if (part.size == 0) return {};
  alignas(16) float lo[4], hi[4];
  const hn::Rebind<float, Doubles> floats;
  for (std::size_t i = 0; i < 4; i += hn::Lanes(doubles)) {
    auto low = hn::LoadU(doubles, &part.corners[0][i]), high = low;
    for (std::size_t corner = 1; corner < part.size; ++corner) {
      const auto at = hn::LoadU(doubles, &part.corners[corner][i]);
      low = hn::Min(low, at);
      high = hn::Max(high, at);
    }
    const auto more = hn::Set(doubles, margin);
    hn::StoreU(round_to_float<-1>(doubles, hn::Sub(low, more)), floats, lo + i);
    hn::StoreU(round_to_float<1>(doubles, hn::Add(high, more)), floats, hi + i);
  }
  return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(clip_to_cell);
HWY_EXPORT(divide_outline);
HWY_EXPORT(box_of_outline);

double outline_margin(const Aabb& box) {
  return 0x1p-43 * largest_component(glm::max(magnitudes(box.lo), magnitudes(box.hi)));
}

bool find_outline(std::span<const Vec3> polygon, const Aabb& whole, const Aabb& cell, double margin,
                  Outline& part) {
  return HWY_DYNAMIC_DISPATCH(clip_to_cell)(polygon, whole, cell, margin, part);
}

bool divide(const Outline& part, const OutlineCut& cut, const OutlineSides& sides) {
  return HWY_DYNAMIC_DISPATCH(divide_outline)(part, cut, sides);
}

Aabb box_of(const Outline& part, double margin) {
  return HWY_DYNAMIC_DISPATCH(box_of_outline)(part, margin);
}

}  // namespace bspview
#endif
