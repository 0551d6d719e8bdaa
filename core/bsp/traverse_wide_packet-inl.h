// Traversal of a wide tree by several rays at once, one in each lane. Included once for every
// instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRAVERSE_WIDE_PACKET) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRAVERSE_WIDE_PACKET
#undef BSPVIEW_TRAVERSE_WIDE_PACKET
#else
#define BSPVIEW_TRAVERSE_WIDE_PACKET
#endif

#include "core/bsp/traverse_wide-inl.h"
#include "core/shape/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// What the walk needs of its rays: directions of the same signs without a component near 0,
/// t_min >= 0.
struct alignas(64) PacketWalk {
  float inverse[3][RayLanes::most];  ///< reciprocals of the directions
  float t_min[RayLanes::most];
  float reach[RayLanes::most];  ///< cells behind are of no use; the leaves make it less, or -inf
  const float (*origin)[RayLanes::most];
  int near_row[3];  ///< of WideNode::bounds

  HWY_INLINE WideRay ray(int lane) const {
    WideRay one;
    for (int axis = 0; axis < 3; ++axis) {
      one.origin[axis] = origin[axis][lane];
      one.inverse[axis] = inverse[axis][lane];
      one.near_row[axis] = near_row[axis];
    }
    one.t_min = t_min[lane];
    return one;
  }
};

/// So many rays, and fewer, go down alone: their cells have little in common.
constexpr std::size_t few_on_the_way = 3;

/// All rays of a packet as one: intervals of their origins and of their reciprocals. Rounding is
/// monotonic, so that no ray passes a cell that the interval misses.
class RayInterval3 {
 public:
  HWY_INLINE RayInterval3(const PacketWalk& walk, hn::Mask<Floats> lanes) {
    const FloatV inf = all(std::numeric_limits<float>::infinity());
    const auto least = [&](const float* x) {
      return hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(lanes, load(x), inf)));
    };
    const auto most = [&](const float* x) {
      return hn::GetLane(hn::MaxOfLanes(floats, hn::IfThenElse(lanes, load(x), hn::Neg(inf))));
    };
    for (int axis = 0; axis < 3; ++axis) {
      const float low = least(walk.origin[axis]), high = most(walk.origin[axis]);
      const bool is_negative = (walk.near_row[axis] & 1) != 0;
      near_row_[axis] = walk.near_row[axis];
      near_origin_[axis] = is_negative ? low : high;
      far_origin_[axis] = is_negative ? high : low;
      least_inverse_[axis] = least(walk.inverse[axis]);
      most_inverse_[axis] = most(walk.inverse[axis]);
    }
  }

  /// The slots whose cells some ray may pass before `reach`, a bit each; enter[slot]: not before.
  HWY_INLINE unsigned find_cells(const WideNode& node, float reach, float* enter) const {
    unsigned found = 0;
    for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(cell_tag)) {
      CellV first = hn::Zero(cell_tag), last = hn::Set(cell_tag, reach);
      for (int axis = 0; axis < 3; ++axis) {
        const CellV a = hn::Set(cell_tag, least_inverse_[axis]);
        const CellV b = hn::Set(cell_tag, most_inverse_[axis]);
        const CellV near = way(node.bounds[near_row_[axis]] + i, near_origin_[axis]);
        const CellV far = way(node.bounds[near_row_[axis] ^ 1] + i, far_origin_[axis]);
        first = hn::Max(first, hn::Min(hn::Mul(near, a), hn::Mul(near, b)));
        last = hn::Min(last, hn::Max(hn::Mul(far, a), hn::Mul(far, b)));
      }
      hn::Store(first, cell_tag, enter + i);
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(cell_tag, hn::Le(first, hn::Mul(last, hn::Set(cell_tag, passing))), bits);
      found |= static_cast<unsigned>(bits[0]) << i;
    }
    return found;
  }

 private:
  static HWY_INLINE CellV way(const float* planes, float origin) {
    return hn::Sub(hn::Load(cell_tag, planes), hn::Set(cell_tag, origin));
  }

  float near_origin_[3], far_origin_[3], least_inverse_[3], most_inverse_[3];
  int near_row_[3];
};

/// The lanes whose rays pass a cell before their reach.
HWY_INLINE unsigned find_lanes(const PacketWalk& walk, const WideNode& node, int slot) {
  FloatV first = load(walk.t_min), last = load(walk.reach);
  for (int axis = 0; axis < 3; ++axis) {
    const int row = walk.near_row[axis];
    const FloatV origin = load(walk.origin[axis]), inverse = load(walk.inverse[axis]);
    first = hn::Max(first, hn::Mul(hn::Sub(all(node.bounds[row][slot]), origin), inverse));
    last = hn::Min(last, hn::Mul(hn::Sub(all(node.bounds[row ^ 1][slot]), origin), inverse));
  }
  return bits_of(floats, hn::Le(first, hn::Mul(last, all(passing))));
}

/// Visits the leaves below a node, ray by ray.
template <class Leaf>
HWY_NOINLINE void go_alone(const WideTree& tree, const PacketWalk& walk, unsigned lanes,
                           std::uint32_t node, Leaf& leaf) {
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = __builtin_ctz(lanes);
    traverse_wide_from(tree, walk.ray(lane), walk.reach[lane], node,
                       [&](std::uint32_t child) { leaf(child, 1u << lane); });
  }
}

/// Visits the leaves that some rays pass, nearest first; leaf(child, lanes) tests the objects.
template <class Leaf>
HWY_INLINE void traverse_wide_packet(const WideTree& tree, const PacketWalk& walk, unsigned lanes,
                                     Leaf&& leaf) {
  const RayInterval3 rays(walk, mask_of(floats, lanes));
  const auto farthest = [&] { return hn::GetLane(hn::MaxOfLanes(floats, load(walk.reach))); };
  WideStack stack;
  float reach = farthest();
  std::uint32_t index = 0;
  for (;;) {
    alignas(32) float enter[WideNode::width];
    const unsigned slots = rays.find_cells(tree.nodes[index], reach, enter);
    stack.push_sorted(slots, enter, [&](int slot) {
      return index * WideNode::width + static_cast<unsigned>(slot);
    });
    for (;;) {
      const std::uint32_t name = stack.pop_child(reach);
      if (name == WideStack::bottom) return;
      const WideNode& node = tree.nodes[name / WideNode::width];
      const int slot = static_cast<int>(name % WideNode::width);
      const unsigned passing_lanes = find_lanes(walk, node, slot);
      if (passing_lanes == 0) continue;
      index = node.child[slot];
      if (index & WideNode::leaf_bit) {
        leaf(index, passing_lanes);
      } else if (hwy::PopCount(passing_lanes) <= few_on_the_way) {
        go_alone(tree, walk, passing_lanes, index, leaf);
      } else {
        break;
      }
      reach = farthest();
    }
  }
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
