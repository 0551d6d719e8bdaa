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

#include "core/shape/ray_lanes.h"
#include "core/shape/triangle.h"

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

/// One bit a lane.
template <class Tag>
HWY_INLINE unsigned bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(tag, mask, bytes);
  return bytes[0] | bytes[1] << 8;
}

/// The lanes of a set, as bits_of answers it.
template <class Tag>
HWY_INLINE hn::Mask<Tag> mask_of(Tag tag, unsigned lanes) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(lanes),
                                 static_cast<std::uint8_t>(lanes >> 8)};
  return hn::LoadMaskBits(tag, bytes);
}

/// Lanes that hit the plane of a triangle, and those where double cannot tell.
struct PlaneHits {
  unsigned hit = 0, open = 0;
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

/// The first stage of hit_triangle_plane, for all lanes; t of those that hit is written.
HWY_INLINE PlaneHits hit_planes(const RayLanes& rays, const TrianglePlane& plane, Sides sides,
                                double* t_out) {
  PlaneHits hits;
  const int step = static_cast<int>(hn::Lanes(doubles));
  const DoubleV zero = hn::Zero(doubles);
  for (int i = 0; i < static_cast<int>(hn::Lanes(floats)); i += step) {
    DoubleV slope = zero, height = zero, slope_size = zero, height_size = zero;
    for (int axis = 0; axis < 3; ++axis) {
      const DoubleV d = load_wide(rays.direction[axis] + i), n = all(plane.normal[axis]);
      const DoubleV way = hn::Sub(all(plane.corner[axis]), load_wide(rays.origin[axis] + i));
      slope = axis == 0 ? hn::Mul(n, d) : hn::Add(slope, hn::Mul(n, d));
      height = axis == 0 ? hn::Mul(n, way) : hn::Add(height, hn::Mul(n, way));
      slope_size = axis == 0 ? hn::Abs(d) : hn::Add(slope_size, hn::Abs(d));
      height_size = axis == 0 ? hn::Abs(way) : hn::Add(height_size, hn::Abs(way));
    }
    const DoubleV t = hn::Div(height, slope), t_min = load_wide(rays.t_min + i);
    hn::Store(t, doubles, t_out + i);
    slope_size = hn::Mul(all(plane.area_size), slope_size);
    height_size = hn::Mul(all(plane.area_size), height_size);
    const auto slope_open = hn::Lt(hn::Abs(slope), hn::Mul(all(0x1p-25), slope_size));
    const auto height_open = hn::Lt(hn::Abs(height), hn::Mul(all(0x1p-25), height_size));
    const auto behind =
        hn::And(hn::Lt(t, zero), hn::Gt(hn::Abs(height), hn::Mul(all(0x1p-48), height_size)));
    const auto is_clear = hn::And(behind, hn::Ge(t_min, zero));
    auto hit = hn::And(hn::Lt(t_min, t), hn::Lt(t, load_wide(rays.t_max + i)));
    if (sides == Sides::front) hit = hn::And(hit, hn::Le(slope, zero));
    const auto open = hn::Or(slope_open, hn::AndNot(is_clear, height_open));
    hits.hit |= bits_of(doubles, hit) << i;
    hits.open |= bits_of(doubles, open) << i;
  }
  hits.hit &= ~hits.open;
  return hits;
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
