// Where several rays, one in each lane, meet the plane of a triangle: as hit_triangle_plane
// (core/shape/triangle.h), bit for bit. Included once for every instruction set that Highway
// (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRIANGLE_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRIANGLE_LANES
#undef BSPVIEW_TRIANGLE_LANES
#else
#define BSPVIEW_TRIANGLE_LANES
#endif

#include <hwy/highway.h>

#include "core/math/mask_bits-inl.h"
#include "core/shape/ray_lanes.h"
#include "core/shape/triangle.h"
#include "core/shape/triangle_block.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, RayLanes::most>;
using Doubles = hn::RepartitionToWide<Floats>;
using FloatV = hn::Vec<Floats>;
using DoubleV = hn::Vec<Doubles>;
inline constexpr Floats floats;
inline constexpr Doubles doubles;

HWY_INLINE FloatV all(float x) {
  return hn::Set(floats, x);
}
HWY_INLINE DoubleV all(double x) {
  return hn::Set(doubles, x);
}
HWY_INLINE FloatV load(const float* x) {
  return hn::Load(floats, x);
}
HWY_INLINE DoubleV load_wide(const float* x) {
  return hn::PromoteTo(doubles, hn::Load(hn::Half<Floats>(), x));
}

/// Lanes whose rays may pass through a triangle, and those of them that surely do.
struct TriangleLanes {
  unsigned possible = 0, sure = 0;
};

/// A triangle in the planes of the rays, see RayQuery::project.
struct TriangleInLanes {
  HWY_INLINE TriangleInLanes(const RayLanes& rays, const TriangleBlock& block, int slot) {
    const FloatV shear_x = load(rays.shear_x), shear_y = load(rays.shear_y);
    for (int i = 0; i < 3; ++i) {
      const auto coordinate = [&](int axis) {
        return hn::Sub(all(block.vertices[i][axis][slot]), load(rays.origin[axis]));
      };
      const FloatV z = coordinate(rays.kz);
      x[i] = hn::NegMulAdd(shear_x, z, coordinate(rays.kx));
      y[i] = hn::NegMulAdd(shear_y, z, coordinate(rays.ky));
    }
  }

  HWY_INLINE FloatV edge_area(int p, int q) const {
    return hn::MulSub(x[p], y[q], hn::Mul(y[p], x[q]));
  }
  HWY_INLINE FloatV size(int p) const { return hn::Add(hn::Abs(x[p]), hn::Abs(y[p])); }

  FloatV x[3], y[3];
};

/// As find_triangles (core/shape/triangle_block-inl.h), one triangle for all lanes.
HWY_INLINE TriangleLanes find_triangle_lanes(const RayLanes& rays, const TriangleBlock& block,
                                             int slot) {
  const TriangleInLanes t(rays, block, slot);
  const FloatV u = t.edge_area(2, 1), v = t.edge_area(0, 2), w = t.edge_area(1, 0);
  const FloatV size = hn::Max(hn::Max(t.size(0), t.size(1)), t.size(2));
  const float r = rays.reach_error;
  const FloatV slope = hn::MulAdd(all(4.0f * unit_roundoff), size, all(18.0f * r));
  const FloatV bound = hn::MulAdd(slope, size, all(160.0f * r * r + 0x1p-120f));
  const FloatV least = hn::Min(u, hn::Min(v, w)), greatest = hn::Max(u, hn::Max(v, w));
  const FloatV below = hn::Neg(bound);
  return {bits_of(floats, hn::Or(hn::Ge(least, below), hn::Le(greatest, bound))),
          bits_of(floats, hn::Or(hn::Gt(least, bound), hn::Lt(greatest, below)))};
}

/// Where some lanes meet the plane of a triangle, which of them hit it, and those where double
/// cannot tell.
struct PlaneHits {
  DoubleV t;
  unsigned hit, open;
};

/// A triangle's plane as hit_triangle_plane sees it.
struct TrianglePlane {
  explicit TrianglePlane(const Vec3* vertices)
      : corner(vertices[0]),
        edge1(Vec3d(vertices[1]) - corner),
        edge2(Vec3d(vertices[2]) - corner),
        normal(glm::cross(edge1, edge2)),
        area_size(sum_of_magnitudes(edge1) * sum_of_magnitudes(edge2)) {}

  Vec3d corner, edge1, edge2, normal;
  double area_size;
};

/// The first stage of hit_triangle_plane, for as many lanes from `first` on as a vector of doubles
/// has.
HWY_INLINE PlaneHits hit_planes(const RayLanes& rays, const TrianglePlane& plane, Sides sides,
                                int first) {
  const DoubleV zero = hn::Zero(doubles);
  DoubleV slope = zero, height = zero, slope_size = zero, height_size = zero;
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleV d = load_wide(rays.direction[axis] + first), n = all(plane.normal[axis]);
    const DoubleV way = hn::Sub(all(plane.corner[axis]), load_wide(rays.origin[axis] + first));
    slope = axis == 0 ? hn::Mul(n, d) : hn::Add(slope, hn::Mul(n, d));
    height = axis == 0 ? hn::Mul(n, way) : hn::Add(height, hn::Mul(n, way));
    slope_size = axis == 0 ? hn::Abs(d) : hn::Add(slope_size, hn::Abs(d));
    height_size = axis == 0 ? hn::Abs(way) : hn::Add(height_size, hn::Abs(way));
  }
  const DoubleV t = hn::Div(height, slope), t_min = load_wide(rays.t_min + first);
  slope_size = hn::Mul(all(plane.area_size), slope_size);
  height_size = hn::Mul(all(plane.area_size), height_size);
  const auto slope_open = hn::Lt(hn::Abs(slope), hn::Mul(all(0x1p-25), slope_size));
  const auto height_open = hn::Lt(hn::Abs(height), hn::Mul(all(0x1p-25), height_size));
  const auto behind =
      hn::And(hn::Lt(t, zero), hn::Gt(hn::Abs(height), hn::Mul(all(0x1p-48), height_size)));
  const auto is_clear = hn::And(behind, hn::Ge(t_min, zero));
  const auto open = hn::Or(slope_open, hn::AndNot(is_clear, height_open));
  auto hit = hn::And(hn::Lt(t_min, t), hn::Lt(t, load_wide(rays.t_max + first)));
  if (sides == Sides::front) hit = hn::And(hit, hn::Le(slope, zero));
  return {t, bits_of(doubles, hn::AndNot(open, hit)), bits_of(doubles, open)};
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
