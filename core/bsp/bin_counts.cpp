#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bsp/bin_counts.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "core/bsp/bin_counts.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Four sides of a box, of which there are six in a row.
constexpr std::size_t side_lanes = 4;
using Floats = hn::CappedTag<float, side_lanes>;
constexpr Floats floats;
constexpr hn::RebindToSigned<Floats> ints;

/// `first`: element of the arrays of `scale` that belongs to the first side.
HWY_INLINE void find_bins(const BinCounts::Scale& scale, float last_bin, const float* sides,
                          std::size_t first, std::int32_t* bins) {
  const auto last = hn::Set(floats, last_bin);
  for (std::size_t lane = 0; lane < side_lanes; lane += hn::Lanes(floats)) {
    const auto lo = hn::Load(floats, scale.lo + first + lane);
    const auto per_width = hn::Load(floats, scale.per_width + first + lane);
    const auto place = hn::Mul(hn::Sub(hn::LoadU(floats, sides + lane), lo), per_width);
    const auto bin = hn::Min(hn::Max(place, hn::Zero(floats)), last);
    hn::Store(hn::ConvertTo(ints, bin), ints, bins + lane);
  }
}

void count_parts(std::span<const ObjectPart> parts, BinCounts& counts) {
  static_assert(offsetof(ObjectPart, box) == 0 && sizeof(Aabb) == 6 * sizeof(float));
  alignas(16) std::int32_t first[side_lanes], last[side_lanes];
  const BinCounts::Scale scale = counts.scale;  // stays in registers
  const float last_bin = static_cast<float>(counts.bins) - 1.0f;
  for (const ObjectPart& part : parts) {
    const auto* const sides = reinterpret_cast<const float*>(&part);
    find_bins(scale, last_bin, sides, 0, first);
    find_bins(scale, last_bin, sides + 2, side_lanes, last);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ++counts.starts[static_cast<std::size_t>(first[axis])][axis];
      ++counts.ends[static_cast<std::size_t>(last[axis + 1])][axis];
    }
  }
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(count_parts);

BinCounts::BinCounts(const Aabb& cell, std::size_t objects)
    : bins(std::clamp(std::bit_floor(objects / 4), fewest, most)) {
  std::fill_n(starts.begin(), bins, ByAxis{});
  std::fill_n(ends.begin(), bins, ByAxis{});
  for (int axis = 0; axis < 3; ++axis) {
    const float width = component(cell.hi, axis) - component(cell.lo, axis);
    const float bins_per_width = static_cast<float>(bins) / width;
    // Where float has no room for bins, all is in the first one.
    if (!std::isfinite(width) || !std::isfinite(bins_per_width)) continue;
    scale.lo[axis] = scale.lo[axis + 5] = component(cell.lo, axis);
    scale.per_width[axis] = scale.per_width[axis + 5] = bins_per_width;
  }
}

void BinCounts::count(std::span<const ObjectPart> parts) {
  HWY_DYNAMIC_DISPATCH(count_parts)(parts, *this);
}

void BinCounts::add(const BinCounts& other) {
  for (std::size_t bin = 0; bin < bins; ++bin) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      starts[bin][axis] += other.starts[bin][axis];
      ends[bin][axis] += other.ends[bin][axis];
    }
  }
}

}  // namespace bspview
#endif
