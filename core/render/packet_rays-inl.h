// Rays side by side, dealt out to classes that run the same way. Included once for every
// instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_PACKET_RAYS) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_PACKET_RAYS
#undef BSPVIEW_PACKET_RAYS
#else
#define BSPVIEW_PACKET_RAYS
#endif

#include <algorithm>
#include <span>

#include "core/shape/round_lanes-inl.h"
#include "core/shape/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

HWY_INLINE int lane_count() {
  return static_cast<int>(hn::Lanes(floats));
}

/// The lowest lane of a set, which loses it.
HWY_INLINE int take_lane(unsigned& lanes) {
  const int lane = __builtin_ctz(lanes);
  lanes &= lanes - 1;
  return lane;
}

/// Lanes whose rays run the same way.
struct RayClass {
  unsigned lanes;
  int main_axis;
  unsigned negative;  ///< bit axis
};

/// The rays of a packet.
class PacketRays : public RayLanes {
 public:
  /// Takes rays in, at most one a lane, to be tested against what is in `box`. Answers the lanes of
  /// those that packets can hold; the others are no rays, start before their origin, or have a
  /// component whose reciprocal could overflow, or a reach whose square could.
  unsigned load_rays(std::span<const Ray> rays, const Aabb& box) {
    const int count = static_cast<int>(rays.size());
    if (count == lane_count()) {
      transpose(rays.data());
    } else {
      Ray padded[RayLanes::most];
      std::fill(std::copy(rays.begin(), rays.end(), padded), std::end(padded), rays.back());
      transpose(padded);
    }
    classes_ = find_classes();
    const unsigned plain = find_plain_rays() & ((1u << count) - 1u);
    find_reach(plain, box);
    return reach_error < 0x1p30f ? plain : 0u;
  }

  /// Calls work(rays) for the classes of `lanes` that are worth it; answers the lanes of the
  /// others, and of those where it answers false.
  template <class Work>
  unsigned for_each_class(unsigned lanes, const Work& work) const {
    constexpr int fewest = 3;  // fewer are faster one by one
    unsigned alone = 0;
    while (lanes != 0) {
      const RayClass next = class_among(lanes);
      lanes &= ~next.lanes;
      if (hwy::PopCount(next.lanes) < fewest || !work(next)) alone |= next.lanes;
    }
    return alone;
  }

  /// Makes ready for the tests of a class.
  void turn_to(const RayClass& rays) {
    kz = rays.main_axis;
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
    const FloatV z = load(direction[kz]);
    hn::Store(hn::Div(load(direction[kx]), z), floats, shear_x);
    hn::Store(hn::Div(load(direction[ky]), z), floats, shear_y);
    const LaneVectors d = directions(*this);
    hn::Store(hn::Sqrt(d.dot(d)), floats, length);
    active = rays.lanes;
  }

 private:
  /// The class of the lowest of `lanes`.
  RayClass class_among(unsigned lanes) const {
    const int lowest = __builtin_ctz(lanes);
    const auto has = [&](unsigned set) { return (set >> lowest & 1u) != 0; };
    const auto same = [&](unsigned set) { return has(set) ? set : ~set; };
    RayClass found{lanes & same(classes_.x_is_main) & same(classes_.y_is_main), 2, 0};
    if (has(classes_.x_is_main)) found.main_axis = 0;
    if (has(classes_.y_is_main)) found.main_axis = 1;
    for (int axis = 0; axis < 3; ++axis) {
      found.lanes &= same(classes_.negative[axis]);
      found.negative |= (classes_.negative[axis] >> lowest & 1u) << axis;
    }
    return found;
  }

  /// Takes in as many rays as there are lanes.
  HWY_INLINE void transpose(const Ray* rays) {
    float* const fields[] = {origin[0],    origin[1],    origin[2], direction[0],
                             direction[1], direction[2], t_min,     t_max};
    static_assert(sizeof(Ray) == sizeof(fields) / sizeof(float*) * sizeof(float));
    const auto* const values = reinterpret_cast<const float*>(rays);
#if HWY_TARGET == HWY_SCALAR
    for (int i = 0; i < 8; ++i) *fields[i] = values[i];
#else
    FloatV low[4], high[4];
    hn::LoadInterleaved4(floats, values, low[0], low[1], low[2], low[3]);
    hn::LoadInterleaved4(floats, values + 4 * lane_count(), high[0], high[1], high[2], high[3]);
    for (int i = 0; i < 4; ++i) {
      hn::Store(hn::ConcatEven(floats, high[i], low[i]), floats, fields[i]);
      hn::Store(hn::ConcatOdd(floats, high[i], low[i]), floats, fields[4 + i]);
    }
#endif
  }

  /// Lanes whose directions are alike: by sign, and by the axis of the largest component.
  struct Classes {
    unsigned negative[3], x_is_main, y_is_main;
  };
  Classes find_classes() const {
    Classes classes;
    FloatV size[3];
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV d = load(direction[axis]);
      size[axis] = hn::Abs(d);
      const auto sign = hn::BitCast(hn::RebindToSigned<Floats>(), d);
      classes.negative[axis] = bits_of(
          floats, hn::RebindMask(floats, hn::Lt(sign, hn::Zero(hn::DFromV<decltype(sign)>()))));
    }
    const unsigned xy = bits_of(floats, hn::Gt(size[0], size[1]));
    classes.x_is_main = xy & bits_of(floats, hn::Gt(size[0], size[2]));
    classes.y_is_main = ~xy & bits_of(floats, hn::Gt(size[1], size[2]));
    return classes;
  }

  unsigned find_plain_rays() const {
    const FloatV start = load(t_min), infinity = all(std::numeric_limits<float>::infinity());
    auto plain = hn::And(hn::Ge(start, hn::Zero(floats)), hn::Lt(start, load(t_max)));
    FloatV largest = hn::Zero(floats);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV size = hn::Abs(load(direction[axis]));
      plain = hn::And(plain, hn::Lt(size, all(0x1p20f)));
      plain = hn::And(plain, hn::Gt(size, all(0x1p-100f)));
      plain = hn::And(plain, hn::Lt(hn::Abs(load(origin[axis])), infinity));
      largest = hn::Max(largest, size);
    }
    return bits_of(floats, hn::And(plain, hn::Gt(largest, all(0x1p-20f))));
  }

  void find_reach(unsigned lanes, const Aabb& box) {
    FloatV reach = hn::Zero(floats);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV from = load(origin[axis]);
      const FloatV below = hn::Abs(hn::Sub(all(box.lo[axis]), from));
      const FloatV above = hn::Abs(hn::Sub(all(box.hi[axis]), from));
      reach = hn::Max(reach, hn::Max(below, above));
    }
    reach = hn::IfThenElseZero(mask_of(floats, lanes), reach);
    reach_error = unit_roundoff * hn::GetLane(hn::MaxOfLanes(floats, reach));
  }

  Classes classes_;
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
