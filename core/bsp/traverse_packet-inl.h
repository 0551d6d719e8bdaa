// Interval traversal of several rays at once, one in each lane, as traverse_robust. All rays have
// directions of the same signs, so that the order of the cells is the same for all. Included once
// for every instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRAVERSE_PACKET) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRAVERSE_PACKET
#undef BSPVIEW_TRAVERSE_PACKET
#else
#define BSPVIEW_TRAVERSE_PACKET
#endif

#include <array>

#include "core/bsp/ray_walk.h"
#include "core/shape/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// What the walk needs of its rays; t_min >= 0.
struct alignas(64) PacketWalk {
  const float (*origin)[RayLanes::most];
  /// Reciprocals of the directions, moved by plane_error: towards and away from 0. Infinite for a
  /// component of 0; planes are then at +-inf, or at NaN for a ray that lies in one.
  float sooner[3][RayLanes::most], later[3][RayLanes::most];
  float enter[RayLanes::most], exit[RayLanes::most];  ///< in the root; empty: enter > exit
  float reach[RayLanes::most];  ///< cells behind are of no use; the leaves make it less
  unsigned negative;            ///< bit axis: directions are negative there
};

/// Visits the leaves along the rays, nearest first; leaf(node, lanes) tests the objects for the
/// lanes that pass the cell.
template <class Leaf>
HWY_INLINE void traverse_packet(const Tree& tree, const PacketWalk& walk, Leaf&& leaf) {
  struct alignas(64) Entry {
    float enter[RayLanes::most], exit[RayLanes::most];
    std::uint32_t node;
  };
  std::array<Entry, depth_cap + 2> stack;  // not initialized
  int depth = 0;
  const Node* const nodes = tree.nodes.data();
  std::uint32_t index = 0;
  FloatV enter = load(walk.enter), exit = load(walk.exit);
  for (;;) {
    const Node node = nodes[index];
    if (!node.is_leaf()) {
      const int axis = node.axis();
      const FloatV way = hn::Sub(all(node.split()), load(walk.origin[axis]));
      const FloatV low = hn::Mul(way, load(walk.sooner[axis]));
      const FloatV high = hn::Mul(way, load(walk.later[axis]));
      // NaN leaves the interval as it is.
      const FloatV near_exit = hn::IfThenElse(hn::Lt(high, exit), high, exit);
      const FloatV far_enter = hn::IfThenElse(hn::Gt(low, enter), low, enter);
      const unsigned near_lanes = bits_of(floats, hn::Le(enter, near_exit));
      const unsigned far_lanes = bits_of(floats, hn::Le(far_enter, exit));
      const std::uint32_t flip = walk.negative >> axis & 1u;
      const std::uint32_t near = node.left() + flip, far = node.right() - flip;
      if (far_lanes == 0) {
        index = near;
        exit = near_exit;
      } else if (near_lanes == 0) {
        index = far;
        enter = far_enter;
      } else {
        Entry& entry = stack[static_cast<std::size_t>(depth++)];
        hn::Store(far_enter, floats, entry.enter);
        hn::Store(exit, floats, entry.exit);
        entry.node = far;
        index = near;
        exit = near_exit;
      }
      continue;
    }
    if (node.count() > 0) leaf(node, bits_of(floats, hn::Le(enter, exit)));
    const FloatV reach = load(walk.reach);
    do {
      if (depth == 0) return;
      const Entry& entry = stack[static_cast<std::size_t>(--depth)];
      index = entry.node;
      enter = load(entry.enter);
      exit = hn::Min(load(entry.exit), reach);
    } while (bits_of(floats, hn::Le(enter, exit)) == 0);
  }
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
