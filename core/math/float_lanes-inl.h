// Neighbours of floats, and rounding to them, in the lanes of vectors. Included once for every
// instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_FLOAT_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_FLOAT_LANES
#undef BSPVIEW_FLOAT_LANES
#else
#define BSPVIEW_FLOAT_LANES
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// next_up of finite floats where `way` is 1, next_down where it is -1; +0 for both zeros.
template <class Floats, class Ints = hn::RebindToSigned<Floats>>
HWY_INLINE hn::Vec<Floats> next_float(Floats floats, hn::Vec<Floats> x, hn::Vec<Ints> way) {
  const Ints ints;
  const auto zero = hn::Zero(ints);
  const auto bits = hn::BitCast(ints, hn::Add(x, hn::Zero(floats)));  // no -0
  const auto sign = hn::ShiftRight<31>(bits);
  const auto next = hn::Add(bits, hn::Sub(hn::Xor(way, sign), sign));
  const auto below_zero = hn::Set(ints, std::numeric_limits<std::int32_t>::min() + 1);
  const auto leaves_zero = hn::And(hn::Eq(bits, zero), hn::Lt(way, zero));
  const auto moved = hn::IfThenElse(leaves_zero, below_zero, next);
  return hn::Add(hn::BitCast(floats, moved), hn::Zero(floats));
}

/// round_up where `way` is 1, round_down where it is -1.
template <int way, class Doubles, class Floats = hn::Rebind<float, Doubles>>
HWY_INLINE hn::Vec<Floats> round_to_float(Doubles doubles, hn::Vec<Doubles> x) {
  const Floats floats;
  const auto nearest = hn::DemoteTo(floats, x);
  const auto back = hn::PromoteTo(doubles, nearest);
  const auto next = next_float(floats, nearest, hn::Set(hn::RebindToSigned<Floats>(), way));
  const auto wrong = way < 0 ? hn::Lt(x, back) : hn::Lt(back, x);
  return hn::DemoteTo(floats, hn::IfThenElse(wrong, hn::PromoteTo(doubles, next), back));
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
