// Hits of several rays at once, one in each lane. Included once for every instruction set that
// Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_PACKET) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_PACKET
#undef BSPVIEW_PACKET
#else
#define BSPVIEW_PACKET
#endif

#include <cstddef>
#include <optional>

#include "core/bsp/packet_walk-inl.h"
#include "core/render/accelerator.h"
#include "core/render/intersect.h"
#include "core/render/packet_rays-inl.h"
#include "core/shape/shear_interval-inl.h"
#include "core/shape/triangle_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// So many rays meet a block or an object one by one: to find out what they pass as a whole, or to
/// test them side by side, is not worth it.
constexpr std::size_t few = 2;

/// Of shears, see ShearInterval::radius.
constexpr float most_spread = 0.25f;

/// Rays of one direction class on their way through a tree.
class Packet {
 public:
  Packet(const World& world, SideRule rule) : world_(world), rule_(rule) {
    walk_.origin = rays_.origin;
  }

  /// As PacketRays::load_rays.
  unsigned load_rays(std::span<const Ray> rays) {
    std::fill_n(best_t_, RayLanes::most, no_hit);
    std::fill_n(best_object_, RayLanes::most, no_index);
    while (has_query_ != 0) queries_[take_lane(has_query_)].reset();
    return rays_.load_rays(rays, world_.tree.box);
  }

  /// Makes ready for each class of `lanes` that is worth it and calls work(rays). Answers the lanes
  /// of the others, among them those whose rays run apart so much that they are faster one by one.
  template <class Work>
  unsigned for_each_class(unsigned lanes, const Work& work) {
    return rays_.for_each_class(lanes, [&](const RayClass& rays) {
      set_class(rays);
      if (interval_.radius() > most_spread) return false;
      work(rays);
      return true;
    });
  }

  const PacketWalk& walk() const { return walk_; }

  /// Keeps what rays of the class hit in a leaf: the nearest, or anything.
  template <bool any>
  HWY_INLINE void meet_leaf(const Accelerator& accelerator, const WideLeaf& leaf, unsigned lanes) {
    for_some_blocks(accelerator.blocks(leaf),
                    [&](auto blocks) { meet_blocks<any>(blocks, lanes & rays_.active); });
    for (const LeafObject& object : accelerator.others(leaf)) {
      meet_object<any>(object, lanes & rays_.active);
    }
  }

  /// What all lanes hit, in a row: the nearest, or any object.
  HWY_INLINE void store(Hit* hits) const {
    constexpr hn::RepartitionToWide<hn::RebindToUnsigned<Floats>> words;
    constexpr hn::Rebind<std::uint32_t, Doubles> ids;
    static_assert(sizeof(Hit) == 2 * sizeof(std::uint64_t) && offsetof(Hit, object) == 8);
    auto* to = reinterpret_cast<std::uint64_t*>(hits);
    for (int first = 0; first < lane_count(); first += static_cast<int>(hn::Lanes(doubles))) {
      const auto t = hn::BitCast(words, hn::Load(doubles, best_t_ + first));
      const auto object = hn::PromoteTo(words, hn::Load(ids, best_object_ + first));
      const auto leaf = hn::Set(words, std::uint64_t{no_leaf} << 32);
      hn::StoreInterleaved2(t, hn::Or(object, leaf), words, to + 2 * first);
    }
  }
  HWY_INLINE void store(std::uint32_t* objects) const {
    constexpr hn::RebindToUnsigned<Floats> ids;
    hn::StoreU(hn::Load(ids, best_object_), ids, objects);
  }

 private:
  void set_class(const RayClass& rays) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    rays_.turn_to(rays);
    interval_ = ShearInterval(rays_, rays.lanes);
    for (int axis = 0; axis < 3; ++axis) {
      walk_.near_row[axis] = 2 * axis + static_cast<int>(rays.negative >> axis & 1u);
      hn::Store(hn::Div(all(1.0f), load(rays_.direction[axis])), floats, walk_.inverse[axis]);
    }
    for (int lane = 0; lane < lane_count(); ++lane) {
      walk_.t_min[lane] = rays_.t_min[lane];
      walk_.reach[lane] = rays.lanes >> lane & 1u ? rays_.t_max[lane] * hit_margin : -inf;
    }
  }

  template <bool any>
  HWY_INLINE void meet_object(const LeafObject& object, unsigned lanes) {
    const Scene& scene = world_.scene;
    const Sides sides = visible_sides(scene, scene.objects[object.id], rule_);
    if (hwy::PopCount(lanes) > few) lanes &= lanes_near(object);
    const bool is_worth_it = hwy::PopCount(lanes) > few;
    if (is_worth_it && object.kind() == ObjectKind::sphere) {
      return meet_lanes<any>(object.id, lanes, [&](const WideLanes& rays) {
        return hit_sphere_lanes(rays, scene.spheres[object.shape], sides);
      });
    }
    if (is_worth_it && object.kind() == ObjectKind::cone) {
      return meet_lanes<any>(object.id, lanes, [&](const WideLanes& rays) {
        return hit_cone_lanes(rays, scene.cone_frames[object.shape], sides);
      });
    }
    while (lanes != 0) {
      const int lane = take_lane(lanes);
      keep<any>(lane, object.id, hit_shape(scene, object.kind(), object.shape, query(lane), sides));
    }
  }

  /// test(rays): what some of the rays hit, as many as a vector of doubles has.
  template <bool any, class Test>
  HWY_INLINE void meet_lanes(std::uint32_t id, unsigned lanes, const Test& test) {
    const int step = static_cast<int>(hn::Lanes(doubles));
    for (int first = 0; first < lane_count(); first += step) {
      const unsigned here = lanes >> first & ((1u << step) - 1u);
      if (here == 0) continue;
      const LaneHits hits = test(WideLanes(rays_, first));
      keep_nearer<any>(id, first, hits.t, hits.hit & here);
    }
  }

  /// The lanes whose rays may hit an object, and perhaps more.
  HWY_INLINE unsigned lanes_near(const LeafObject& object) const {
    const Scene& scene = world_.scene;
    if (object.kind() == ObjectKind::sphere) {
      return lanes_near_sphere(rays_, scene.spheres[object.shape]);
    }
    if (object.kind() == ObjectKind::cone) {
      return lanes_near_cone(rays_, scene.cones[object.shape]);
    }
    return ~0u;
  }

  HWY_INLINE BlockRay block_ray(int lane) const {
    const int kx = rays_.kx, ky = rays_.ky, kz = rays_.kz;
    return {kx,
            ky,
            kz,
            {rays_.origin[kx][lane], rays_.origin[ky][lane], rays_.origin[kz][lane]},
            rays_.shear_x[lane],
            rays_.shear_y[lane],
            rays_.reach_error};
  }

  template <bool any>
  HWY_INLINE void meet_blocks(std::span<const TriangleBlock> blocks, unsigned lanes) {
    std::uint32_t places[blocks_at_once * TriangleBlock::width];
    const std::size_t lane_tests = hwy::PopCount(lanes) * blocks.size();
    std::size_t found = lane_tests + 1;
    if (hwy::PopCount(lanes) > few) found = interval_.list_places(blocks, places);
    if (found <= lane_tests) return meet_places<any>(blocks, std::span(places, found), lanes);
    meet_lane_by_lane<any>(blocks, lanes);
  }

  /// All lanes at once, triangle after triangle, named by place: block and slot. All tests before
  /// any that depend on what they find: so the processor works on several at a time.
  template <bool any>
  HWY_INLINE void meet_places(std::span<const TriangleBlock> blocks,
                              std::span<std::uint32_t> places, unsigned lanes) {
    TriangleLanes found[blocks_at_once * TriangleBlock::width];
    const auto block_of = [&](std::uint32_t place) -> const TriangleBlock& {
      return blocks[place / TriangleBlock::width];
    };
    const auto slot_of = [&](std::uint32_t place) {
      return static_cast<int>(place % TriangleBlock::width);
    };
    std::size_t count = 0;
    for (const std::uint32_t place : places) {
      found[count] = find_triangle_lanes(rays_, block_of(place), slot_of(place));
      found[count].possible &= lanes;
      found[count].sure &= lanes;
      places[count] = place;
      count += static_cast<std::size_t>(found[count].possible != 0);
    }
    for (std::size_t i = 0; i < count; ++i) {
      settle_slot<any>(block_of(places[i]), slot_of(places[i]), found[i]);
    }
  }

  template <bool any>
  HWY_INLINE void meet_lane_by_lane(std::span<const TriangleBlock> blocks, unsigned lanes) {
    BlocksHits hits[RayLanes::most];
    std::uint64_t possible = 0;
    for (unsigned rest = lanes; rest != 0;) {
      const int lane = take_lane(rest);
      hits[lane] = find_triangles(block_ray(lane), blocks);
      possible |= hits[lane].possible;
    }
    for (; possible != 0; possible &= possible - 1) {
      const int place = __builtin_ctzll(possible);
      TriangleLanes found;
      for (unsigned rest = lanes; rest != 0;) {
        const int lane = take_lane(rest);
        found.possible |= static_cast<unsigned>(hits[lane].possible >> place & 1u) << lane;
        found.sure |= static_cast<unsigned>(hits[lane].sure >> place & 1u) << lane;
      }
      settle_slot<any>(blocks[static_cast<std::size_t>(place / TriangleBlock::width)],
                       place % TriangleBlock::width, found);
    }
  }

  template <bool any>
  HWY_INLINE void settle_slot(const TriangleBlock& block, int slot, TriangleLanes found) {
    Vec3 vertices[3];
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) vertices[i][axis] = block.vertices[i][axis][slot];
    }
    const unsigned sure = found.sure & rays_.active;
    const unsigned open = found.possible & ~found.sure & rays_.active;
    settle_triangle<any>(block.object[slot], vertices, sure, open);
  }

  template <bool any>
  HWY_NOINLINE void settle_triangle(std::uint32_t id, const Vec3* vertices, unsigned sure,
                                    unsigned open) {
    const Sides sides = visible_sides(world_.scene, world_.scene.objects[id], rule_);
    if (sure != 0) settle_sure_hits<any>(id, vertices, sides, sure);
    while (open != 0) {
      const int lane = take_lane(open);
      keep<any>(lane, id, hit_triangle_exactly(query(lane), vertices, sides));
    }
  }

  /// Of rays that pass through the triangle, in front of their origins or behind.
  template <bool any>
  HWY_INLINE void settle_sure_hits(std::uint32_t id, const Vec3* vertices, Sides sides,
                                   unsigned lanes) {
    const TrianglePlane plane(vertices);
    const int step = static_cast<int>(hn::Lanes(doubles));
    for (int first = 0; first < lane_count(); first += step) {
      const unsigned here = lanes >> first & ((1u << step) - 1u);
      if (here == 0) continue;
      const PlaneHits planes = hit_planes(rays_, plane, sides, first);
      keep_nearer<any>(id, first, planes.t, planes.hit & here);
      for (unsigned open = planes.open & here; open != 0;) {
        const int lane = first + take_lane(open);
        keep<any>(lane, id, hit_triangle_plane(query(lane), vertices, sides));
      }
    }
  }

  /// The ray of a lane by itself, made when it is first needed.
  const RayQuery& query(int lane) {
    std::optional<RayQuery>& query = queries_[lane];
    has_query_ |= 1u << lane;
    if (!query)
      query.emplace(rays_.ray(lane), rays_.reach_error * 0x1p24f, has_triangles(world_.scene));
    return *query;
  }

  /// Keeps t of those of `lanes`, counted from `first` on, where it is the nearest so far.
  template <bool any>
  HWY_INLINE void keep_nearer(std::uint32_t id, int first, DoubleV t, unsigned lanes) {
    constexpr hn::Half<Floats> halves;
    constexpr hn::RebindToUnsigned<decltype(halves)> ids;
    const DoubleV best = hn::Load(doubles, best_t_ + first);
    const auto best_ids = hn::Load(ids, best_object_ + first);
    const unsigned smaller = bits_of(ids, hn::Lt(hn::Set(ids, id), best_ids));
    const unsigned nearer =
        lanes & (bits_of(doubles, hn::Lt(t, best)) | (bits_of(doubles, hn::Eq(t, best)) & smaller));
    if (nearer == 0) return;
    hn::BlendedStore(t, mask_of(doubles, nearer), doubles, best_t_ + first);
    hn::BlendedStore(hn::Set(ids, id), mask_of(ids, nearer), ids, best_object_ + first);
    const auto reach = hn::Mul(hn::DemoteTo(halves, t), hn::Set(halves, hit_margin));
    hn::BlendedStore(reach, mask_of(halves, nearer), halves, walk_.reach + first);
    if (any) end_rays(nearer << first);
  }

  template <bool any>
  HWY_INLINE void keep(int lane, std::uint32_t id, double t) {
    const double best = best_t_[lane];
    if (t == no_hit || !(t < best || (t == best && id < best_object_[lane]))) return;
    best_t_[lane] = t;
    best_object_[lane] = id;
    walk_.reach[lane] = static_cast<float>(t) * hit_margin;
    if (any) end_rays(1u << lane);
  }

  /// Rays that have found enough.
  HWY_INLINE void end_rays(unsigned lanes) {
    rays_.active &= ~lanes;
    hn::BlendedStore(all(-std::numeric_limits<float>::infinity()), mask_of(floats, lanes), floats,
                     walk_.reach);
  }

  const World& world_;
  SideRule rule_;
  PacketRays rays_;
  PacketWalk walk_;
  ShearInterval interval_;
  alignas(64) double best_t_[RayLanes::most];
  alignas(64) std::uint32_t best_object_[RayLanes::most];
  std::optional<RayQuery> queries_[RayLanes::most];
  unsigned has_query_ = 0;
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
