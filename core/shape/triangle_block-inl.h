// The triangle test of one ray against eight triangles, as hit_triangle (core/shape/triangle.h).
// Included once for every instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRIANGLE_BLOCK) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRIANGLE_BLOCK
#undef BSPVIEW_TRIANGLE_BLOCK
#else
#define BSPVIEW_TRIANGLE_BLOCK
#endif

#include <hwy/highway.h>

#include "core/shape/triangle.h"
#include "core/shape/triangle_block.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Slots that the ray may pass through, and those of them where that is sure.
struct BlockHits {
  unsigned possible = 0, sure = 0;
};

/// What the test needs of a ray: these members of a RayQuery.
struct BlockRay {
  int kx, ky, kz;
  Vec3 turned;
  float shear_x, shear_y, reach_error;
};

/// The vertices of some triangles in the plane of a ray, see RayQuery::project.
template <class Tag>
struct ProjectedTriangles {
  using V = hn::Vec<Tag>;

  template <class AnyRay>
  HWY_INLINE ProjectedTriangles(Tag tag, const AnyRay& ray, const TriangleBlock& block,
                                std::size_t first) {
    const V shear_x = hn::Set(tag, ray.shear_x), shear_y = hn::Set(tag, ray.shear_y);
    for (int i = 0; i < 3; ++i) {
      const auto coordinate = [&](int axis, float origin) {
        return hn::Sub(hn::Load(tag, block.vertices[i][axis] + first), hn::Set(tag, origin));
      };
      const V z = coordinate(ray.kz, ray.turned.z);
      x[i] = hn::Sub(coordinate(ray.kx, ray.turned.x), hn::Mul(shear_x, z));
      y[i] = hn::Sub(coordinate(ray.ky, ray.turned.y), hn::Mul(shear_y, z));
    }
  }

  HWY_INLINE V edge_area(int p, int q) const {
    return hn::Sub(hn::Mul(x[p], y[q]), hn::Mul(y[p], x[q]));
  }
  HWY_INLINE V size(int p) const { return hn::Add(hn::Abs(x[p]), hn::Abs(y[p])); }

  V x[3], y[3];
};

/// See hit_triangle for the bound. NaN is outside. AnyRay: a RayQuery or a BlockRay.
template <class AnyRay>
HWY_INLINE BlockHits find_triangles(const AnyRay& ray, const TriangleBlock& block) {
  constexpr hn::CappedTag<float, TriangleBlock::width> tag;
  using V = hn::Vec<decltype(tag)>;
  BlockHits hits;
  for (std::size_t first = 0; first < TriangleBlock::width; first += hn::Lanes(tag)) {
    const ProjectedTriangles<hn::CappedTag<float, TriangleBlock::width>> t(tag, ray, block, first);
    const V u = t.edge_area(2, 1), v = t.edge_area(0, 2), w = t.edge_area(1, 0);
    const V size = hn::Max(hn::Max(t.size(0), t.size(1)), t.size(2));
    const float r = ray.reach_error;
    const V slope =
        hn::Add(hn::Set(tag, 18.0f * r), hn::Mul(hn::Set(tag, 4.0f * unit_roundoff), size));
    const V bound = hn::Add(hn::Mul(slope, size), hn::Set(tag, 160.0f * r * r + 0x1p-120f));
    const V least = hn::Min(u, hn::Min(v, w)), greatest = hn::Max(u, hn::Max(v, w));
    const V below = hn::Neg(bound);
    const auto bits = [&](hn::Mask<decltype(tag)> mask) {
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(tag, mask, bytes);
      return static_cast<unsigned>(bytes[0]) << first;
    };
    hits.possible |= bits(hn::Or(hn::Ge(least, below), hn::Le(greatest, bound)));
    if (hits.possible == 0) continue;
    hits.sure |= bits(hn::Or(hn::Gt(least, bound), hn::Lt(greatest, below)));
  }
  return hits;
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
