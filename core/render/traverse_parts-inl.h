// Traversal of an accelerator and of its parts, which are trees in its leaves. Included once for
// every instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRAVERSE_PARTS) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRAVERSE_PARTS
#undef BSPVIEW_TRAVERSE_PARTS
#else
#define BSPVIEW_TRAVERSE_PARTS
#endif

#include "core/bsp/traverse_wide_packet-inl.h"
#include "core/render/lazy_part.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

template <class Leaf>
HWY_NOINLINE void traverse_part(const LazyPart& part, const WideRay& ray, const float& reach,
                                Leaf& leaf);
template <bool any, class Meet>
HWY_NOINLINE void traverse_part_packet(const LazyPart& part, const PacketWalks& walks,
                                       const PacketLanes& lanes, Meet& meet);

/// Visits the leaves along the ray, nearest first, as traverse_wide; leaf(accelerator, child) tests
/// the objects of a leaf of that accelerator.
template <class Leaf>
HWY_INLINE void traverse_parts(const Accelerator& accelerator, const WideRay& ray,
                               const float& reach, Leaf& leaf) {
  traverse_wide(accelerator.tree(), ray, reach, [&](std::uint32_t child) {
    if (const LazyPart* part = accelerator.part(child)) {
      return traverse_part(*part, ray, reach, leaf);
    }
    leaf(accelerator, child);
  });
}

template <class Leaf>
HWY_NOINLINE void traverse_part(const LazyPart& part, const WideRay& ray, const float& reach,
                                Leaf& leaf) {
  traverse_parts(part.accelerator(), ray, reach, leaf);
}

/// The same for packets, as traverse_wide_packets; meet(packet, accelerator, child, lanes).
template <bool any, class Meet>
HWY_INLINE void traverse_parts_packets(const Accelerator& accelerator, const PacketWalks& walks,
                                       const PacketLanes& lanes, Meet& meet) {
  const auto leaf = [&](int packet, std::uint32_t child, unsigned some) {
    if (const LazyPart* part = accelerator.part(child)) {
      return traverse_part_packet<any>(*part, walks, PacketLanes::only(packet, some), meet);
    }
    meet(packet, accelerator, child, some);
  };
  traverse_wide_packets<any>(accelerator.tree(), walks, lanes, 0, leaf);
}

template <bool any, class Meet>
HWY_NOINLINE void traverse_part_packet(const LazyPart& part, const PacketWalks& walks,
                                       const PacketLanes& lanes, Meet& meet) {
  traverse_parts_packets<any>(part.accelerator(), walks, lanes, meet);
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
