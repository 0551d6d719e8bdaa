// The triangle test of one ray against eight triangles. It answers as hit_triangle
// (core/shape/triangle.h), bit for bit: where fused products round less than that does, they may
// leave fewer signs open, and what is decided is the same. Included once for every instruction set
// that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRIANGLE_BLOCK) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRIANGLE_BLOCK
#undef BSPVIEW_TRIANGLE_BLOCK
#else
#define BSPVIEW_TRIANGLE_BLOCK
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <span>

#include "core/math/mask_bits-inl.h"
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
      x[i] = hn::NegMulAdd(shear_x, z, coordinate(ray.kx, ray.turned.x));
      y[i] = hn::NegMulAdd(shear_y, z, coordinate(ray.ky, ray.turned.y));
    }
  }

  HWY_INLINE V edge_area(int p, int q) const { return hn::MulSub(x[p], y[q], hn::Mul(y[p], x[q])); }
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
    const V slope = hn::MulAdd(hn::Set(tag, 4.0f * unit_roundoff), size, hn::Set(tag, 18.0f * r));
    const V bound = hn::MulAdd(slope, size, hn::Set(tag, 160.0f * r * r + 0x1p-120f));
    const V least = hn::Min(u, hn::Min(v, w)), greatest = hn::Max(u, hn::Max(v, w));
    const V below = hn::Neg(bound);
    const auto possible = hn::Or(hn::Ge(least, below), hn::Le(greatest, bound));
    const auto sure = hn::Or(hn::Gt(least, bound), hn::Lt(greatest, below));
    hits.possible |= bits_of(tag, possible) << first;
    hits.sure |= bits_of(tag, sure) << first;
  }
  return hits;
}

/// So many blocks are met together.
inline constexpr std::size_t blocks_at_once = 8;

/// The same of up to blocks_at_once blocks, a byte each, the first the lowest.
struct BlocksHits {
  std::uint64_t possible = 0, sure = 0;
};

/// All tests before any that depend on what they find: so the processor works on several at a time.
template <class AnyRay>
HWY_INLINE BlocksHits find_triangles(const AnyRay& ray, std::span<const TriangleBlock> blocks) {
  BlocksHits all;
  int place = 0;
  for (const TriangleBlock& block : blocks) {
    const BlockHits hits = find_triangles(ray, block);
    all.possible |= std::uint64_t{hits.possible} << place;
    all.sure |= std::uint64_t{hits.sure} << place;
    place += TriangleBlock::width;
  }
  return all;
}

/// Calls work(some) for the blocks, blocks_at_once at a time.
template <class Work>
HWY_INLINE void for_some_blocks(std::span<const TriangleBlock> blocks, const Work& work) {
  for (std::size_t first = 0; first < blocks.size(); first += blocks_at_once) {
    work(blocks.subspan(first, std::min(blocks_at_once, blocks.size() - first)));
  }
}

/// Slots whose triangles' planes a ray hits, and those where double cannot tell.
struct BlockPlanes {
  unsigned hit = 0, open = 0;
  unsigned behind = 0;  ///< from behind
  alignas(64) double t[TriangleBlock::width];
};

/// The vertices of some triangles of a block, seen from the origin of a ray, in double.
template <class Tag>
struct WideTriangles {
  using V = hn::Vec<Tag>;

  HWY_INLINE WideTriangles(Tag tag, const TriangleBlock& block, std::size_t first) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto coordinate = [&](int vertex) {
        return hn::PromoteTo(
            tag, hn::Load(hn::Rebind<float, Tag>(), block.vertices[vertex][axis] + first));
      };
      corner[axis] = coordinate(0);
      edge1[axis] = hn::Sub(coordinate(1), corner[axis]);
      edge2[axis] = hn::Sub(coordinate(2), corner[axis]);
    }
  }

  HWY_INLINE V normal(int axis) const {
    const int j = axis == 2 ? 0 : axis + 1, k = j == 2 ? 0 : j + 1;
    return hn::Sub(hn::Mul(edge1[j], edge2[k]), hn::Mul(edge2[j], edge1[k]));
  }
  static HWY_INLINE V sum_of_magnitudes(const V* v) {
    return hn::Add(hn::Add(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2]));
  }

  V corner[3], edge1[3], edge2[3];
};

/// So many triangles meet a ray in double at once: mostly one is wanted, and wider vectors take
/// longer.
using PlaneTag = hn::CappedTag<double, 4>;

/// Tells of the `wanted` slots from `first` on, and may of others, what the first stage of
/// hit_triangle_plane does.
template <class AnyRay>
HWY_INLINE void find_some_planes(const AnyRay& ray, const TriangleBlock& block, unsigned wanted,
                                 std::size_t first, BlockPlanes& planes) {
  constexpr PlaneTag tag;
  using V = hn::Vec<PlaneTag>;
  const V zero = hn::Zero(tag);
  const WideTriangles<PlaneTag> triangles(tag, block, first);
  V way[3], slope = zero, height = zero;
  for (int axis = 0; axis < 3; ++axis) {
    const V normal = triangles.normal(axis);
    way[axis] = hn::Sub(triangles.corner[axis], hn::Set(tag, ray.wide_origin[axis]));
    const V slope_here = hn::Mul(normal, hn::Set(tag, ray.wide_direction[axis]));
    const V height_here = hn::Mul(normal, way[axis]);
    slope = axis == 0 ? slope_here : hn::Add(slope, slope_here);
    height = axis == 0 ? height_here : hn::Add(height, height_here);
  }
  const V area_size = hn::Mul(triangles.sum_of_magnitudes(triangles.edge1),
                              triangles.sum_of_magnitudes(triangles.edge2));
  const V height_size = hn::Mul(area_size, triangles.sum_of_magnitudes(way));
  const V slope_size = hn::Mul(hn::Mul(hn::Set(tag, 0x1p-25), area_size),
                               hn::Set(tag, sum_of_magnitudes(ray.wide_direction)));
  const auto slope_open = hn::Lt(hn::Abs(slope), slope_size);
  const auto height_open = hn::Lt(hn::Abs(height), hn::Mul(hn::Set(tag, 0x1p-25), height_size));
  // Signs that differ: t <= 0, as most are where rays leave a surface.
  constexpr hn::RebindToSigned<PlaneTag> ints;
  const auto signs = hn::BitCast(ints, hn::Xor(height, slope));
  const auto behind = hn::And(hn::RebindMask(tag, hn::Lt(signs, hn::Zero(ints))),
                              hn::Ge(hn::Set(tag, ray.t_min), zero));
  const auto is_clear =
      hn::And(behind, hn::Gt(hn::Abs(height), hn::Mul(hn::Set(tag, 0x1p-48), height_size)));
  const auto open = hn::Or(slope_open, hn::AndNot(is_clear, height_open));
  const auto bits = [&](hn::Mask<PlaneTag> mask) { return bits_of(tag, mask) << first; };
  planes.open |= bits(open);
  if ((wanted & ~bits(hn::Or(behind, open)) & (((1u << hn::Lanes(tag)) - 1u) << first)) == 0)
    return;
  const V t = hn::Div(height, slope);
  const auto inside =
      hn::And(hn::Lt(hn::Set(tag, ray.t_min), t), hn::Lt(t, hn::Set(tag, ray.t_max)));
  hn::StoreU(t, tag, planes.t + first);
  planes.hit |= bits(hn::AndNot(open, inside));
  planes.behind |= bits(hn::Gt(slope, zero));
}

/// The same of all the wanted slots, at least one.
template <class AnyRay>
HWY_INLINE void find_planes(const AnyRay& ray, const TriangleBlock& block, unsigned wanted,
                            BlockPlanes& planes) {
  const unsigned lanes = static_cast<unsigned>(hn::Lanes(PlaneTag()));
  for (unsigned rest = wanted; rest != 0;) {
    const unsigned first = static_cast<unsigned>(__builtin_ctz(rest)) & ~(lanes - 1u);
    find_some_planes(ray, block, wanted, first, planes);
    rest &= ~(((1u << lanes) - 1u) << first);
  }
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
