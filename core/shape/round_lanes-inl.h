// Where several rays, one in each lane, hit a sphere or a cone: first by their lines, in float,
// with bounds on all rounding; then as hit_sphere and hit_cone, bit for bit. Included once for
// every instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_ROUND_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_ROUND_LANES
#undef BSPVIEW_ROUND_LANES
#else
#define BSPVIEW_ROUND_LANES
#endif

#include "core/shape/cone.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// A vector in each lane, of floats or doubles.
template <class V>
struct VectorsInLanes {
  V x, y, z;

  HWY_INLINE V dot(const VectorsInLanes& other) const {
    return hn::Add(hn::Add(hn::Mul(x, other.x), hn::Mul(y, other.y)), hn::Mul(z, other.z));
  }
  HWY_INLINE VectorsInLanes cross(const VectorsInLanes& other) const {
    const auto minor = [](V a, V b, V c, V d) { return hn::Sub(hn::Mul(a, b), hn::Mul(c, d)); };
    return {minor(y, other.z, z, other.y), minor(z, other.x, x, other.z),
            minor(x, other.y, y, other.x)};
  }
  HWY_INLINE V sum_of_magnitudes() const {
    return hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
  }
  HWY_INLINE VectorsInLanes operator+(const VectorsInLanes& other) const {
    return {hn::Add(x, other.x), hn::Add(y, other.y), hn::Add(z, other.z)};
  }
  HWY_INLINE VectorsInLanes operator-(const VectorsInLanes& other) const {
    return {hn::Sub(x, other.x), hn::Sub(y, other.y), hn::Sub(z, other.z)};
  }
  HWY_INLINE VectorsInLanes operator*(V factor) const {
    return {hn::Mul(factor, x), hn::Mul(factor, y), hn::Mul(factor, z)};
  }
};
using LaneVectors = VectorsInLanes<FloatV>;
using WideLaneVectors = VectorsInLanes<DoubleV>;

HWY_INLINE LaneVectors directions(const RayLanes& rays) {
  return {load(rays.direction[0]), load(rays.direction[1]), load(rays.direction[2])};
}
/// From a point to the origins of the rays; rounded once.
HWY_INLINE LaneVectors origins_from(const RayLanes& rays, const Vec3& point) {
  return {hn::Sub(load(rays.origin[0]), all(point.x)), hn::Sub(load(rays.origin[1]), all(point.y)),
          hn::Sub(load(rays.origin[2]), all(point.z))};
}

/// |f x d| > r |d| where the line passes beside the sphere. Rounding moves |f x d| by less than 9
/// units of |f| |d| (sums of magnitudes), and relatively by 3 units for each sum of squares.
HWY_INLINE unsigned lanes_near_sphere(const RayLanes& rays, const Sphere& sphere) {
  const LaneVectors d = directions(rays), f = origins_from(rays, sphere.centre);
  const LaneVectors beside = f.cross(d);
  const FloatV error =
      hn::Mul(all(16.0f * unit_roundoff), hn::Mul(f.sum_of_magnitudes(), d.sum_of_magnitudes()));
  const FloatV far = hn::Add(hn::Mul(all(std::abs(sphere.radius)), load(rays.length)), error);
  const FloatV far2 =
      hn::Add(hn::Mul(hn::Mul(far, far), all(1.0f + 16.0f * unit_roundoff)), all(0x1p-120f));
  return ~bits_of(floats, hn::Gt(beside.dot(beside), far2));
}

/// |f . n| > r |n|, n = d x axis, where the line passes beside the cylinder around the cone.
/// Rounding moves n by less than 8 units of |d| |axis|, and f . n by 32 of |f| |d| |axis|.
HWY_INLINE unsigned lanes_near_cone(const RayLanes& rays, const Cone& cone) {
  const Vec3 axis = cone.apex - cone.base;
  const LaneVectors d = directions(rays), f = origins_from(rays, cone.base);
  const LaneVectors n = d.cross({all(axis.x), all(axis.y), all(axis.z)});
  const FloatV size =
      hn::Mul(d.sum_of_magnitudes(), all(static_cast<float>(sum_of_magnitudes(axis))));
  const FloatV error = hn::Mul(hn::Mul(all(32.0f * unit_roundoff), size), f.sum_of_magnitudes());
  const float widest = std::max(std::abs(cone.base_radius), std::abs(cone.apex_radius));
  const FloatV length = hn::Add(
      hn::Mul(hn::Sqrt(hn::Add(n.dot(n), all(0x1p-120f))), all(1.0f + 8.0f * unit_roundoff)),
      hn::Mul(all(8.0f * unit_roundoff), size));
  const FloatV far = hn::Add(hn::Mul(length, all(widest * (1.0f + 4.0f * unit_roundoff))),
                             hn::Add(error, all(0x1p-120f)));
  return ~bits_of(floats, hn::Gt(hn::Abs(f.dot(n)), far));
}

HWY_INLINE WideLaneVectors all(const Vec3d& v) {
  return {all(v.x), all(v.y), all(v.z)};
}

/// As many rays from lane `first` on as a vector of doubles has.
struct WideLanes {
  HWY_INLINE WideLanes(const RayLanes& rays, int first)
      : origin{load_wide(rays.origin[0] + first), load_wide(rays.origin[1] + first),
               load_wide(rays.origin[2] + first)},
        direction{load_wide(rays.direction[0] + first), load_wide(rays.direction[1] + first),
                  load_wide(rays.direction[2] + first)},
        length2(direction.dot(direction)),
        t_min(load_wide(rays.t_min + first)),
        t_max(load_wide(rays.t_max + first)) {}

  HWY_INLINE hn::Mask<Doubles> accept(DoubleV t) const {
    return hn::And(hn::Lt(t_min, t), hn::Lt(t, t_max));
  }

  WideLaneVectors origin, direction;
  DoubleV length2, t_min, t_max;
};

/// Where some lanes hit something: one bit each, and their t.
struct LaneHits {
  DoubleV t;
  unsigned hit;
};

HWY_INLINE LaneHits hit_sphere_lanes(const WideLanes& rays, const Sphere& sphere, Sides sides) {
  const DoubleV zero = hn::Zero(doubles);
  const WideLaneVectors f = rays.origin - all(Vec3d(sphere.centre));
  const DoubleV r2 = all(static_cast<double>(sphere.radius) * sphere.radius);
  const WideLaneVectors beside = f.cross(rays.direction);
  const DoubleV discriminant = hn::Sub(hn::Mul(rays.length2, r2), beside.dot(beside));
  const auto passes = hn::Ge(discriminant, zero);
  const DoubleV b = hn::Neg(f.dot(rays.direction)), root = hn::Sqrt(discriminant);
  const auto ahead = hn::Ge(b, zero);
  const DoubleV q = hn::IfThenElse(ahead, hn::Add(b, root), hn::Sub(b, root));
  const DoubleV c = hn::Sub(f.dot(f), r2);
  const DoubleV other = hn::IfThenElse(hn::Eq(q, zero), zero, hn::Div(c, q));
  const DoubleV one = hn::Div(q, rays.length2);
  const DoubleV enter = hn::IfThenElse(ahead, other, one);
  const DoubleV leave = hn::IfThenElse(ahead, one, other);
  const bool outside_visible = sides == Sides::both || sphere.radius > 0.0f;
  const bool inside_visible = sides == Sides::both || sphere.radius < 0.0f;
  const auto none = hn::Ne(zero, zero);
  const auto enters = outside_visible ? hn::And(passes, rays.accept(enter)) : none;
  const auto leaves = inside_visible ? hn::And(passes, rays.accept(leave)) : none;
  return {hn::IfThenElse(enters, enter, leave), bits_of(doubles, hn::Or(enters, leaves))};
}

/// As passes_far_from_axis of hit_cone: without it, rays beside a thin cone are lost in rounding.
HWY_INLINE hn::Mask<Doubles> pass_far_from_axis(const WideLanes& rays, const ConeFrame& cone,
                                                const WideLaneVectors& from_base) {
  const WideLaneVectors across = rays.direction.cross(all(cone.axis));
  const DoubleV distance = from_base.dot(across);
  const DoubleV sizes2 = hn::Mul(hn::Mul(from_base.dot(from_base), rays.length2), all(cone.axis2));
  const DoubleV near = hn::Mul(all((1.0 + 0x1p-12) * cone.widest2), across.dot(across));
  return hn::Gt(hn::Mul(distance, distance), hn::Add(near, hn::Mul(all(0x1p-80), sizes2)));
}

HWY_INLINE LaneHits hit_cone_lanes(const WideLanes& rays, const ConeFrame& cone, Sides sides) {
  const DoubleV zero = hn::Zero(doubles), one = all(1.0);
  const WideLaneVectors& d = rays.direction;
  const WideLaneVectors axis = all(cone.axis);
  const WideLaneVectors from_base = rays.origin - all(cone.base);
  const DoubleV shift =
      hn::Mul((all(0.5 * cone.axis) - from_base).dot(d), hn::Div(one, rays.length2));
  const WideLaneVectors f = from_base + d * shift;
  const DoubleV m = hn::Mul(f.dot(axis), all(cone.per_axis2));
  const DoubleV n = hn::Mul(d.dot(axis), all(cone.per_axis2));
  const WideLaneVectors f_across = f - axis * m, d_across = d - axis * n;
  const DoubleV radius = hn::Add(all(cone.base_radius), hn::Mul(all(cone.growth), m));
  const DoubleV slope = hn::Mul(all(cone.growth), n);
  const DoubleV a = hn::Sub(d_across.dot(d_across), hn::Mul(slope, slope));
  const DoubleV b = hn::Sub(hn::Mul(radius, slope), f_across.dot(d_across));
  const DoubleV c = hn::Sub(f_across.dot(f_across), hn::Mul(radius, radius));
  const DoubleV discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(a, c));
  const DoubleV q = hn::Add(b, hn::CopySign(hn::Sqrt(discriminant), b));
  const auto no_a = hn::Eq(a, zero), no_q = hn::Eq(q, zero);
  const auto misses = hn::Or(hn::And(no_a, no_q), pass_far_from_axis(rays, cone, from_base));
  const auto passes = hn::AndNot(misses, hn::Ge(discriminant, zero));
  const DoubleV one_root = hn::IfThenElse(no_a, all(no_hit), hn::Div(q, a));
  const DoubleV other_root = hn::IfThenElse(no_q, zero, hn::Div(c, q));
  const auto is_later = hn::Gt(one_root, other_root);
  const DoubleV near = hn::IfThenElse(is_later, other_root, one_root);
  const DoubleV far = hn::IfThenElse(is_later, one_root, other_root);
  const auto hits = [&](DoubleV root) {
    const DoubleV s = hn::Add(m, hn::Mul(root, n));
    auto hit = hn::And(hn::And(hn::Le(zero, s), hn::Le(s, one)), rays.accept(hn::Add(shift, root)));
    if (sides == Sides::front) {
      const auto enters = hn::Lt(hn::Sub(hn::Mul(a, root), b), zero);
      hit = cone.is_inside_out ? hn::AndNot(enters, hit) : hn::And(enters, hit);
    }
    return hn::And(passes, hit);
  };
  const auto near_hits = hits(near), far_hits = hits(far);
  return {hn::Add(shift, hn::IfThenElse(near_hits, near, far)),
          bits_of(doubles, hn::Or(near_hits, far_hits))};
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
