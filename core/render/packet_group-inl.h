// Packets of rays that go through the tree together. Included once for every instruction set that
// Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_PACKET_GROUP) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_PACKET_GROUP
#undef BSPVIEW_PACKET_GROUP
#else
#define BSPVIEW_PACKET_GROUP
#endif

#include <array>

#include "core/render/packet-inl.h"
#include "core/render/traverse_parts-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// Neighbouring packets. Those whose rays all run the same way find their cells together.
class PacketGroup {
 public:
  PacketGroup(const World& world, SideRule rule)
      : world_(world),
        packets_{Packet(world, rule), Packet(world, rule), Packet(world, rule),
                 Packet(world, rule)} {
    for (int i = 0; i < PacketWalks::most; ++i) walks_.of[i] = &packets_[i].walk();
  }
  PacketGroup(const PacketGroup&) = delete;
  PacketGroup& operator=(const PacketGroup&) = delete;

  /// Rays at a time.
  static std::size_t width() {
    return static_cast<std::size_t>(PacketWalks::most) * static_cast<std::size_t>(lane_count());
  }

  /// Finds what rays hit, at most width() of them: the nearest, or anything.
  template <bool any>
  void trace(std::span<const Ray> rays) {
    const auto meet = [&](int packet, const Accelerator& accelerator, std::uint32_t child,
                          unsigned lanes) {
      packets_[packet].template meet_leaf<any>(accelerator, accelerator.leaf(child), lanes);
    };
    for_each_way(rays, [&](const PacketLanes& lanes) {
      traverse_parts_packets(*world_.accelerator, walks_, lanes, meet);
    });
  }

  /// The walk alone, each ray to the end of its interval; or only what comes before it. Answers the
  /// names of the leaves, added up.
  std::uint64_t walk(std::span<const Ray> rays, bool walks) {
    std::uint64_t sum = 0;
    const auto pass = [&](int, const Accelerator&, std::uint32_t child, unsigned) { sum += child; };
    for_each_way(rays, [&](const PacketLanes& lanes) {
      if (walks) traverse_parts_packets(*world_.accelerator, walks_, lanes, pass);
    });
    return sum;
  }

  /// Whether a ray was traced: others are faster alone, or no rays that packets can hold.
  bool has(std::size_t ray) const { return (traced_[packet_of(ray)] >> lane_of(ray) & 1) != 0; }
  Hit best(std::size_t ray) const { return packets_[packet_of(ray)].best(lane_of(ray)); }

 private:
  static std::size_t packet_of(std::size_t ray) {
    return ray / static_cast<std::size_t>(lane_count());
  }
  static int lane_of(std::size_t ray) {
    return static_cast<int>(ray % static_cast<std::size_t>(lane_count()));
  }

  /// Calls go(lanes) for rays that go together: packet by packet for those of several classes, last
  /// for all whose packets run the same way.
  template <class Go>
  void for_each_way(std::span<const Ray> rays, const Go& go) {
    PacketLanes together;
    const auto width = static_cast<std::size_t>(lane_count());
    for (int i = 0; !rays.empty(); ++i) {
      const auto some = rays.first(std::min(width, rays.size()));
      const unsigned lanes = packets_[i].load_rays(some);
      const unsigned alone = packets_[i].for_each_class(lanes, [&](const RayClass& one) {
        if (one.lanes == lanes && joins(i, together)) {
          together.of[i] = lanes;
        } else {
          go(PacketLanes::only(i, one.lanes));
        }
      });
      traced_[i] = lanes & ~alone;
      rays = rays.subspan(some.size());
    }
    if (packets_of(together) != 0) go(together);
  }

  bool joins(int packet, const PacketLanes& together) const {
    const unsigned others = packets_of(together);
    return others == 0 || walks_.of[packet]->runs_as(*walks_.of[__builtin_ctz(others)]);
  }

  const World& world_;
  Packet packets_[PacketWalks::most];
  PacketWalks walks_;
  unsigned traced_[PacketWalks::most];
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
