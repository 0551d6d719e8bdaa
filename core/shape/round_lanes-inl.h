// Which rays, one in each lane, may hit a sphere or a cone: by their lines, in float, with bounds
// on all rounding. Included once for every instruction set that Highway (hwy/foreach_target.h)
// compiles for.

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

/// A vector in each lane.
struct LaneVectors {
  FloatV x, y, z;

  HWY_INLINE FloatV dot(const LaneVectors& other) const {
    return hn::Add(hn::Add(hn::Mul(x, other.x), hn::Mul(y, other.y)), hn::Mul(z, other.z));
  }
  HWY_INLINE LaneVectors cross(const LaneVectors& other) const {
    const auto minor = [](FloatV a, FloatV b, FloatV c, FloatV d) {
      return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
    };
    return {minor(y, other.z, z, other.y), minor(z, other.x, x, other.z),
            minor(x, other.y, y, other.x)};
  }
  HWY_INLINE FloatV sum_of_magnitudes() const {
    return hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
  }
};

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

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
