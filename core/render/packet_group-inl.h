// Packets of rays that go through the tree together. Included once for every instruction set that
// Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_PACKET_GROUP) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_PACKET_GROUP
#undef BSPVIEW_PACKET_GROUP
#else
#define BSPVIEW_PACKET_GROUP
#endif

#include <algorithm>
#include <span>

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
      traverse_parts_packets<any>(*world_.accelerator, walks_, lanes, meet);
    });
  }

  /// The walk alone, each ray to the end of its interval; or only what comes before it. Answers the
  /// names of the leaves, added up.
  std::uint64_t walk(std::span<const Ray> rays, bool walks) {
    std::uint64_t sum = 0;
    const auto pass = [&](int, const Accelerator&, std::uint32_t child, unsigned) { sum += child; };
    for_each_way(rays, [&](const PacketLanes& lanes) {
      if (walks) traverse_parts_packets<false>(*world_.accelerator, walks_, lanes, pass);
    });
    return sum;
  }

  /// What the rays hit, see Packet::store; nothing to rely on for those left over.
  template <class Answer>
  void store(std::span<Answer> answers) const {
    const auto width = static_cast<std::size_t>(lane_count());
    const Packet* packet = packets_;
    for (; answers.size() >= width; answers = answers.subspan(width)) {
      (packet++)->store(answers.data());
    }
    if (answers.empty()) return;
    Answer all[RayLanes::most];
    packet->store(all);
    std::copy_n(all, answers.size(), answers.data());
  }

  /// Calls work(ray) for those left over: they are faster alone, or no rays that packets can hold.
  template <class Work>
  void for_each_alone(const Work& work) const {
    std::size_t first = 0;
    for (const unsigned lanes : alone_) {
      for (unsigned rest = lanes; rest != 0;) {
        work(first + static_cast<std::size_t>(take_lane(rest)));
      }
      first += static_cast<std::size_t>(lane_count());
    }
  }

 private:
  /// Calls go(lanes) for rays that go together: packet by packet for those of several classes, last
  /// for all whose packets run the same way.
  template <class Go>
  void for_each_way(std::span<const Ray> rays, const Go& go) {
    PacketLanes together;
    std::ranges::fill(alone_, 0u);
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
      alone_[i] = ((1u << some.size()) - 1u) & (alone | ~lanes);
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
  unsigned alone_[PacketWalks::most];
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
