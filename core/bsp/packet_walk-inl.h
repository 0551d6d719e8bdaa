// Rays side by side on their way through a wide tree, and all of them as one. Included once for
// every instruction set that Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_PACKET_WALK) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_PACKET_WALK
#undef BSPVIEW_PACKET_WALK
#else
#define BSPVIEW_PACKET_WALK
#endif

#include "core/bsp/traverse_wide-inl.h"
#include "core/shape/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// What the walk needs of the rays of a packet, one in each lane: directions of the same signs
/// without a component near 0, t_min >= 0.
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

  bool runs_as(const PacketWalk& other) const {
    return std::equal(near_row, near_row + 3, other.near_row);
  }
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

/// Packets that go together: those whose rays run the same way.
struct PacketWalks {
  static constexpr int most = 4;

  const PacketWalk* of[most];
};

/// Some rays of some packets.
struct PacketLanes {
  unsigned of[PacketWalks::most] = {};  ///< by packet, one bit a lane

  static PacketLanes only(int packet, unsigned lanes) {
    PacketLanes some;
    some.of[packet] = lanes;
    return some;
  }
};

/// The packets that have some lanes, a bit each.
HWY_INLINE unsigned packets_of(const PacketLanes& lanes) {
  unsigned packets = 0;
  for (int i = 0; i < PacketWalks::most; ++i) {
    packets |= static_cast<unsigned>(lanes.of[i] != 0) << i;
  }
  return packets;
}

/// Calls work(packet) for each bit of a set.
template <class Work>
HWY_INLINE void for_each_packet(unsigned packets, const Work& work) {
  for (int i = 0; i < PacketWalks::most; ++i) {
    if ((packets >> i & 1u) != 0) work(i);
  }
}

/// The farthest reach of the rays of some packets.
HWY_INLINE float farthest_reach(const PacketWalks& walks, unsigned packets) {
  FloatV reach = all(-std::numeric_limits<float>::infinity());
  for_each_packet(packets, [&](int i) { reach = hn::Max(reach, load(walks.of[i]->reach)); });
  return hn::GetLane(hn::MaxOfLanes(floats, reach));
}

/// Some rays of some packets as one: intervals of their origins and of their reciprocals. Rounding
/// is monotonic, so that no ray passes a cell that the interval misses.
class RayInterval3 {
 public:
  HWY_INLINE RayInterval3(const PacketWalks& walks, const PacketLanes& lanes) {
    const unsigned packets = packets_of(lanes);
    const PacketWalk& any_walk = *walks.of[__builtin_ctz(packets)];
    for (int axis = 0; axis < 3; ++axis) {
      Extent origin, inverse;
      for_each_packet(packets, [&](int i) {
        const auto some = mask_of(floats, lanes.of[i]);
        origin.include(load(walks.of[i]->origin[axis]), some);
        inverse.include(load(walks.of[i]->inverse[axis]), some);
      });
      near_row_[axis] = any_walk.near_row[axis];
      const bool is_negative = (near_row_[axis] & 1) != 0;
      near_origin_[axis] = is_negative ? origin.least() : origin.most();
      far_origin_[axis] = is_negative ? origin.most() : origin.least();
      least_inverse_[axis] = inverse.least();
      most_inverse_[axis] = inverse.most();
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
      last = hn::Mul(last, hn::Set(cell_tag, passing));
      found |= bits_of(cell_tag, hn::Le(first, last)) << i;
    }
    return found;
  }

 private:
  /// The least and the most of the numbers in some lanes.
  struct Extent {
    HWY_INLINE Extent()
        : low(all(std::numeric_limits<float>::infinity())),
          high(all(-std::numeric_limits<float>::infinity())) {}
    HWY_INLINE void include(FloatV x, hn::Mask<Floats> some) {
      low = hn::IfThenElse(some, hn::Min(low, x), low);
      high = hn::IfThenElse(some, hn::Max(high, x), high);
    }
    HWY_INLINE float least() const { return hn::GetLane(hn::MinOfLanes(floats, low)); }
    HWY_INLINE float most() const { return hn::GetLane(hn::MaxOfLanes(floats, high)); }

    FloatV low, high;
  };

  static HWY_INLINE CellV way(const float* planes, float origin) {
    return hn::Sub(hn::Load(cell_tag, planes), hn::Set(cell_tag, origin));
  }

  float near_origin_[3], far_origin_[3], least_inverse_[3], most_inverse_[3];
  int near_row_[3];
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
