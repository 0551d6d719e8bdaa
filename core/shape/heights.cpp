#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shape/heights.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include "core/base/check.h"
#include "core/math/mask_bits-inl.h"
#include "core/shape/heights.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using FloatV = hn::Vec<Floats>;
constexpr Floats floats;
constexpr hn::RebindToSigned<Floats> ints;

/// One coordinate of as many points as a vector has lanes. In the three vectors that hold the
/// points each is in a lane of its own: two blends bring them together, one permutation into their
/// order.
class Coordinates {
 public:
  HWY_INLINE explicit Coordinates(int axis) {
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(floats));
    const auto lane = hn::Iota(ints, 0), last = hn::Set(ints, lanes - 1);
    const auto three = hn::Set(ints, 3), first = hn::Set(ints, axis);
    const auto number = [&](auto point) { return hn::Add(hn::Mul(three, point), first); };
    places_ = hn::And(number(lane), last);
    // The point whose number is in a lane: 3 x 11 is 1 modulo the lanes, a power of two up to 32.
    const auto point = hn::And(hn::Mul(hn::Sub(lane, first), hn::Set(ints, 11)), last);
    in_first_ = hn::RebindMask(floats, hn::Lt(number(point), hn::Set(ints, lanes)));
    in_second_ = hn::RebindMask(floats, hn::Lt(number(point), hn::Set(ints, 2 * lanes)));
  }

  HWY_INLINE FloatV load(const float* points) const {
    const std::size_t lanes = hn::Lanes(floats);
    const auto vector = [&](std::size_t i) { return hn::LoadU(floats, points + i * lanes); };
    const FloatV behind = hn::IfThenElse(in_second_, vector(1), vector(2));
    const FloatV mixed = hn::IfThenElse(in_first_, vector(0), behind);
    return hn::TableLookupLanes(mixed, hn::IndicesFromVec(floats, places_));
  }

 private:
  hn::Vec<decltype(ints)> places_;
  hn::Mask<Floats> in_first_, in_second_;
};

Heights find_heights(std::span<const Vec3> points, int axis, float height) {
  const std::size_t lanes = hn::Lanes(floats);
  const Coordinates coordinates(axis);
  const auto* const numbers = reinterpret_cast<const float*>(points.data());
  FloatV nearest = hn::Set(floats, std::numeric_limits<float>::infinity());
  Heights heights;
  std::size_t i = 0;
  for (; i + lanes <= points.size(); i += lanes) {
    const FloatV h = hn::Sub(coordinates.load(numbers + 3 * i), hn::Set(floats, height));
    nearest = hn::Min(hn::Abs(h), nearest);
    const auto is_below = hn::Lt(hn::BitCast(ints, h), hn::Zero(ints));
    heights.below |= std::uint64_t{bits_of(ints, is_below)} << i;
  }
  heights.nearest = hn::GetLane(hn::MinOfLanes(floats, nearest));
  for (; i < points.size(); ++i) heights.add(i, component(points[i], axis) - height);
  return heights;
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(find_heights);

Heights heights_of(std::span<const Vec3> points, int axis, float height) {
  BSPVIEW_CHECK(points.size() <= Heights::most);
  return HWY_DYNAMIC_DISPATCH(find_heights)(points, axis, height);
}

}  // namespace bspview
#endif
