// Traversal of a wide tree by packets of rays. Included once for every instruction set that Highway
// (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRAVERSE_WIDE_PACKET) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRAVERSE_WIDE_PACKET
#undef BSPVIEW_TRAVERSE_WIDE_PACKET
#else
#define BSPVIEW_TRAVERSE_WIDE_PACKET
#endif

#include "core/bsp/packet_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// So many rays of a packet, and fewer, go down alone: their cells have little in common.
constexpr std::size_t few_on_the_way = 3;

/// Visits the leaves below a node, ray by ray.
template <class Leaf>
HWY_NOINLINE void go_alone(const WideTree& tree, const PacketWalks& walks, int packet,
                           unsigned lanes, std::uint32_t node, Leaf& leaf) {
  const PacketWalk& walk = *walks.of[packet];
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = __builtin_ctz(lanes);
    traverse_wide_from(tree, walk.ray(lane), walk.reach[lane], node,
                       [&](std::uint32_t child) { leaf(packet, child, 1u << lane); });
  }
}

/// Visits the leaves below a node that some rays pass, nearest first, or where anything will do
/// those that take the fewest steps; leaf(packet, child, lanes) tests the objects. Packets go
/// together until one is left, which goes on by itself.
template <bool any, class Leaf>
HWY_NOINLINE void traverse_wide_packets(const WideTree& tree, const PacketWalks& walks,
                                        const PacketLanes& lanes, std::uint32_t index, Leaf& leaf) {
  const RayInterval3 rays(walks, lanes);
  const unsigned packets = packets_of(lanes);
  WideStack stack;
  float reach = farthest_reach(walks, packets);
  for (;;) {
    alignas(64) float enter[WideNode::width];
    const unsigned slots = rays.find_cells(tree.nodes[index], reach, enter);
    const auto name_of = [&](int slot) {
      return index * WideNode::width + static_cast<unsigned>(slot);
    };
    if constexpr (any) {
      stack.push_all(slots, enter, name_of);
    } else {
      stack.push_sorted(slots, enter, name_of);
    }
    for (;;) {
      const std::uint32_t name = stack.pop_child(reach);
      if (name == WideStack::bottom) return;
      const WideNode& node = tree.nodes[name / WideNode::width];
      const int slot = static_cast<int>(name % WideNode::width);
      PacketLanes here;
      for_each_packet(packets, [&](int i) { here.of[i] = find_lanes(*walks.of[i], node, slot); });
      const unsigned packets_here = packets_of(here);
      if (packets_here == 0) continue;
      index = node.child[slot];
      const int packet = __builtin_ctz(packets_here);
      const bool is_one = std::has_single_bit(packets_here);
      if (index & WideNode::leaf_bit) {
        for_each_packet(packets_here, [&](int i) { leaf(i, index, here.of[i]); });
      } else if (is_one && hwy::PopCount(here.of[packet]) <= few_on_the_way) {
        go_alone(tree, walks, packet, here.of[packet], index, leaf);
      } else if (is_one && packets != packets_here) {
        traverse_wide_packets<any>(tree, walks, here, index, leaf);
      } else {
        break;
      }
      reach = farthest_reach(walks, packets);
    }
  }
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
