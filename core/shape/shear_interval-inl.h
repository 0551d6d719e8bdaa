// Which triangles of a block a packet of rays may hit, told by all its rays as one. Included once
// for every instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_SHEAR_INTERVAL) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_SHEAR_INTERVAL
#undef BSPVIEW_SHEAR_INTERVAL
#else
#define BSPVIEW_SHEAR_INTERVAL
#endif

#include "core/shape/triangle_block.h"
#include "core/shape/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// The rays of a packet in the planes of kx, kz and of ky, kz, each a line x = shear z + intercept:
/// the least and the greatest of the shears and of the intercepts. A ray that hits a triangle has
/// its intercept between the least and the greatest v.x - shear v.z of the vertices v.
///
/// All is seen from the origin of one of the rays, base: no vertex is farther from it than the
/// reach of the packet, no origin than twice that. Rounding moves, in units of reach_error,
/// v.x - base, v.z - base and the shear by 1 each, its mid and radius by 2, products and
/// differences by 9, the intercept by 12: the interval is wider by `slack`.
class ShearInterval {
 public:
  ShearInterval() = default;
  HWY_INLINE ShearInterval(const RayLanes& rays, unsigned lanes) {
    const int first = __builtin_ctz(lanes), axes[2] = {rays.kx, rays.ky};
    const auto active = mask_of(floats, lanes);
    const FloatV inf = all(std::numeric_limits<float>::infinity());
    z_ = rays.kz;
    base_z_ = rays.origin[z_][first];
    const FloatV z = hn::Sub(load(rays.origin[z_]), all(base_z_));
    const auto least = [&](FloatV x) {
      return hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(active, x, inf)));
    };
    const auto greatest = [&](FloatV x) {
      return hn::GetLane(hn::MaxOfLanes(floats, hn::IfThenElse(active, x, hn::Neg(inf))));
    };
    for (int i = 0; i < 2; ++i) {
      Side& side = sides_[i];
      side.axis = axes[i];
      side.base = rays.origin[side.axis][first];
      const FloatV shear = load(i == 0 ? rays.shear_x : rays.shear_y);
      const FloatV x = hn::Sub(load(rays.origin[side.axis]), all(side.base));
      const FloatV intercept = hn::NegMulAdd(shear, z, x);
      const float least_shear = least(shear), greatest_shear = greatest(shear);
      side.shear = 0.5f * (least_shear + greatest_shear);
      side.shear_radius = 0.5f * (greatest_shear - least_shear);
      side.least = least(intercept) - slack * rays.reach_error;
      side.greatest = greatest(intercept) + slack * rays.reach_error;
    }
  }

  /// Half the difference between the shears of two rays, at most.
  float radius() const { return std::max(sides_[0].shear_radius, sides_[1].shear_radius); }

  /// The triangles that some ray may pass through, each by its place: 8 times the number of its
  /// block, and its slot. `places` has room for all of the blocks. Answers how many they are.
  HWY_INLINE std::size_t list_places(std::span<const TriangleBlock> blocks,
                                     std::uint32_t* places) const {
    constexpr BlockTag tag;
    constexpr hn::RebindToUnsigned<BlockTag> ids;
    std::size_t count = 0;
    std::uint32_t place = 0;
    for (const TriangleBlock& block : blocks) {
      for (std::size_t slot = 0; slot < TriangleBlock::width; slot += hn::Lanes(tag)) {
        const auto found = hn::RebindMask(ids, passes(block, slot));
        hn::StoreU(hn::Compress(hn::Iota(ids, place), found), ids, places + count);
        count += hn::CountTrue(ids, found);
        place += static_cast<std::uint32_t>(hn::Lanes(tag));
      }
    }
    return count;
  }

 private:
  using BlockTag = hn::CappedTag<float, TriangleBlock::width>;
  using BlockV = hn::Vec<BlockTag>;

  static constexpr float slack = 64.0f;  ///< in units of reach_error

  HWY_INLINE hn::Mask<BlockTag> passes(const TriangleBlock& block, std::size_t slot) const {
    constexpr BlockTag tag;
    const auto depth_of = [&](int vertex) {
      return hn::Sub(hn::Load(tag, block.vertices[vertex][z_] + slot), hn::Set(tag, base_z_));
    };
    const BlockV depths[3] = {depth_of(0), depth_of(1), depth_of(2)};
    return hn::And(sides_[0].passes(block, slot, depths), sides_[1].passes(block, slot, depths));
  }

  struct Side {
    HWY_INLINE hn::Mask<BlockTag> passes(const TriangleBlock& block, std::size_t slot,
                                         const BlockV* depths) const {
      constexpr BlockTag tag;
      const auto place = [&](int i) {
        const BlockV x = hn::Sub(hn::Load(tag, block.vertices[i][axis] + slot), hn::Set(tag, base));
        return hn::NegMulAdd(hn::Set(tag, shear), depths[i], x);
      };
      const BlockV a = place(0), b = place(1), c = place(2);
      const BlockV depth =
          hn::Max(hn::Max(hn::Abs(depths[0]), hn::Abs(depths[1])), hn::Abs(depths[2]));
      const BlockV radius = hn::Set(tag, shear_radius);
      const BlockV low = hn::NegMulAdd(radius, depth, hn::Min(a, hn::Min(b, c)));
      const BlockV high = hn::MulAdd(radius, depth, hn::Max(a, hn::Max(b, c)));
      return hn::And(hn::Le(low, hn::Set(tag, greatest)), hn::Ge(high, hn::Set(tag, least)));
    }

    int axis;
    float base, shear, shear_radius, least, greatest;
  };

  int z_;
  float base_z_;
  Side sides_[2];
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
