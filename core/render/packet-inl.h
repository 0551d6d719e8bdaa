// Hits of several rays at once by the wide tree. Included once for every instruction set that
// Highway (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_PACKET) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_PACKET
#undef BSPVIEW_PACKET
#else
#define BSPVIEW_PACKET
#endif

#include <optional>

#include "core/render/accelerator.h"
#include "core/render/intersect.h"
#include "core/render/traverse_parts-inl.h"
#include "core/shape/triangle_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

constexpr int most = RayLanes::most;

HWY_INLINE int lane_count() {
  return static_cast<int>(hn::Lanes(floats));
}

/// The lowest lane of a set, which loses it.
HWY_INLINE int take_lane(unsigned& lanes) {
  const int lane = __builtin_ctz(lanes);
  lanes &= lanes - 1;
  return lane;
}

/// Rays of one direction class on their way through a tree.
class Packet {
 public:
  Packet(const World& world, SideRule rule) : world_(world), rule_(rule) {
    walk_.origin = rays_.origin;
  }

  /// Takes rays in, at most one a lane. Answers the lanes of those that packets can hold; the
  /// others are no rays, start before their origin, or have a component whose reciprocal could
  /// overflow.
  unsigned load_rays(std::span<const Ray> rays) {
    const int count = static_cast<int>(rays.size());
    for (int lane = 0; lane < lane_count(); ++lane) {
      const Ray& ray = rays[static_cast<std::size_t>(std::min(lane, count - 1))];
      rays_.origin[0][lane] = ray.origin.x;
      rays_.origin[1][lane] = ray.origin.y;
      rays_.origin[2][lane] = ray.origin.z;
      rays_.direction[0][lane] = ray.direction.x;
      rays_.direction[1][lane] = ray.direction.y;
      rays_.direction[2][lane] = ray.direction.z;
      rays_.t_min[lane] = ray.t_min;
      rays_.t_max[lane] = ray.t_max;
      best_t_[lane] = no_hit;
      best_object_[lane] = no_index;
      queries_[lane].reset();
    }
    classes_ = find_classes();
    const unsigned plain = find_plain_rays() & ((1u << count) - 1u);
    find_reach(plain);
    return plain;
  }

  /// Lanes whose rays run the same way.
  struct Class {
    unsigned lanes;
    int main_axis;
    unsigned negative;  ///< bit axis
  };
  /// Calls work(rays) for the classes of `lanes` that are worth it; answers the lanes of the
  /// others.
  template <class Work>
  unsigned for_each_class(unsigned lanes, const Work& work) const {
    constexpr int fewest = 3;  // fewer are faster one by one
    unsigned alone = 0;
    while (lanes != 0) {
      const Class next = class_among(lanes);
      lanes &= ~next.lanes;
      if (hwy::PopCount(next.lanes) < fewest) {
        alone |= next.lanes;
      } else {
        work(next);
      }
    }
    return alone;
  }

  /// The class of the lowest of `lanes`.
  Class class_among(unsigned lanes) const {
    const int lowest = __builtin_ctz(lanes);
    const auto has = [&](unsigned set) { return (set >> lowest & 1u) != 0; };
    const auto same = [&](unsigned set) { return has(set) ? set : ~set; };
    Class found{lanes & same(classes_.x_is_main) & same(classes_.y_is_main), 2, 0};
    if (has(classes_.x_is_main)) found.main_axis = 0;
    if (has(classes_.y_is_main)) found.main_axis = 1;
    for (int axis = 0; axis < 3; ++axis) {
      found.lanes &= same(classes_.negative[axis]);
      found.negative |= (classes_.negative[axis] >> lowest & 1u) << axis;
    }
    return found;
  }

  /// Finds what the rays of a class hit: the nearest, or anything.
  template <bool any>
  void trace(const Class& rays) {
    set_class(rays);
    const auto meet = [this](const Accelerator& accelerator, std::uint32_t child, unsigned lanes) {
      meet_leaf<any>(accelerator, accelerator.leaf(child), lanes);
    };
    traverse_parts_packet(*world_.accelerator, walk_, rays.lanes, meet);
  }

  /// The walk alone, each lane to its end; none: makes ready, no more. Answers the names of the
  /// leaves, added up.
  std::uint64_t walk(const Class& rays, std::span<const float> ends) {
    set_class(rays);
    std::uint64_t sum = 0;
    if (ends.empty()) return sum;
    for (unsigned rest = rays.lanes; rest != 0;) {
      const int lane = take_lane(rest);
      walk_.reach[lane] = ends[static_cast<std::size_t>(lane)] * hit_margin;
    }
    const auto pass = [&](const Accelerator&, std::uint32_t child, unsigned) { sum += child; };
    traverse_parts_packet(*world_.accelerator, walk_, rays.lanes, pass);
    return sum;
  }

  Hit best(int lane) const { return {best_t_[lane], best_object_[lane], no_leaf}; }

 private:
  /// Lanes whose directions are alike: by sign, and by the axis of the largest component.
  struct Classes {
    unsigned negative[3], x_is_main, y_is_main;
  };
  Classes find_classes() const {
    Classes classes;
    FloatV size[3];
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV d = load(rays_.direction[axis]);
      size[axis] = hn::Abs(d);
      const auto sign = hn::BitCast(hn::RebindToSigned<Floats>(), d);
      classes.negative[axis] = bits_of(
          floats, hn::RebindMask(floats, hn::Lt(sign, hn::Zero(hn::DFromV<decltype(sign)>()))));
    }
    const unsigned xy = bits_of(floats, hn::Gt(size[0], size[1]));
    classes.x_is_main = xy & bits_of(floats, hn::Gt(size[0], size[2]));
    classes.y_is_main = ~xy & bits_of(floats, hn::Gt(size[1], size[2]));
    return classes;
  }

  unsigned find_plain_rays() const {
    const FloatV t_min = load(rays_.t_min), infinity = all(std::numeric_limits<float>::infinity());
    auto plain = hn::And(hn::Ge(t_min, hn::Zero(floats)), hn::Lt(t_min, load(rays_.t_max)));
    FloatV largest = hn::Zero(floats);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV size = hn::Abs(load(rays_.direction[axis]));
      plain = hn::And(plain, hn::Lt(size, all(0x1p20f)));
      plain = hn::And(plain, hn::Gt(size, all(0x1p-100f)));
      plain = hn::And(plain, hn::Lt(hn::Abs(load(rays_.origin[axis])), infinity));
      largest = hn::Max(largest, size);
    }
    return bits_of(floats, hn::And(plain, hn::Gt(largest, all(0x1p-20f))));
  }

  void find_reach(unsigned lanes) {
    FloatV reach = hn::Zero(floats);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV origin = load(rays_.origin[axis]);
      const FloatV below = hn::Abs(hn::Sub(all(world_.tree.box.lo[axis]), origin));
      const FloatV above = hn::Abs(hn::Sub(all(world_.tree.box.hi[axis]), origin));
      reach = hn::Max(reach, hn::Max(below, above));
    }
    reach = hn::IfThenElseZero(mask_of(floats, lanes), reach);
    rays_.reach_error = unit_roundoff * hn::GetLane(hn::MaxOfLanes(floats, reach));
  }

  void set_class(const Class& rays) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    rays_.kz = rays.main_axis;
    rays_.kx = rays_.kz == 2 ? 0 : rays_.kz + 1;
    rays_.ky = rays_.kx == 2 ? 0 : rays_.kx + 1;
    const FloatV z = load(rays_.direction[rays_.kz]);
    hn::Store(hn::Div(load(rays_.direction[rays_.kx]), z), floats, rays_.shear_x);
    hn::Store(hn::Div(load(rays_.direction[rays_.ky]), z), floats, rays_.shear_y);
    rays_.active = rays.lanes;
    for (int axis = 0; axis < 3; ++axis) {
      walk_.near_row[axis] = 2 * axis + static_cast<int>(rays.negative >> axis & 1u);
      hn::Store(hn::Div(all(1.0f), load(rays_.direction[axis])), floats, walk_.inverse[axis]);
    }
    for (int lane = 0; lane < lane_count(); ++lane) {
      walk_.t_min[lane] = rays_.t_min[lane];
      walk_.reach[lane] = rays.lanes >> lane & 1u ? rays_.t_max[lane] : -inf;
    }
  }

  template <bool any>
  HWY_INLINE void meet_leaf(const Accelerator& accelerator, const WideLeaf& leaf, unsigned lanes) {
    const TriangleBlock* block = accelerator.blocks() + leaf.first_block;
    for (std::uint32_t i = 0; i < leaf.block_count; ++i, ++block) {
      lanes &= rays_.active;
      if (lanes == 0) return;
      meet_block<any>(*block, lanes);
    }
    for (const std::uint32_t id : accelerator.others(leaf)) {
      for (unsigned rest = lanes & rays_.active; rest != 0;) {
        const int lane = take_lane(rest);
        keep<any>(lane, id, hit_object(world_.scene, id, query(lane), rule_));
      }
    }
  }

  /// The lanes of the rays that may pass through each triangle of a block, and that surely do.
  struct BlockLanes {
    unsigned possible[TriangleBlock::width] = {}, sure[TriangleBlock::width] = {};
    unsigned slots = 0;  ///< with any
  };

  HWY_INLINE BlockLanes find_block_lanes(const TriangleBlock& block, unsigned lanes) const {
    BlockLanes found;
    while (lanes != 0) {
      const int lane = take_lane(lanes);
      BlockHits hits = find_triangles(block_ray(lane), block);
      found.slots |= hits.possible;
      for (; hits.possible != 0; hits.possible &= hits.possible - 1) {
        const int slot = __builtin_ctz(hits.possible);
        found.possible[slot] |= 1u << lane;
        found.sure[slot] |= (hits.sure >> slot & 1u) << lane;
      }
    }
    return found;
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
  HWY_INLINE void meet_block(const TriangleBlock& block, unsigned lanes) {
    BlockLanes found = find_block_lanes(block, lanes);
    for (; found.slots != 0; found.slots &= found.slots - 1) {
      const int slot = __builtin_ctz(found.slots);
      Vec3 vertices[3];
      for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) vertices[i][axis] = block.vertices[i][axis][slot];
      }
      const unsigned sure = found.sure[slot] & rays_.active;
      const unsigned open = found.possible[slot] & ~found.sure[slot] & rays_.active;
      settle_triangle<any>(block.object[slot], vertices, sure, open);
    }
  }

  template <bool any>
  HWY_NOINLINE void settle_triangle(std::uint32_t id, const Vec3* vertices, unsigned sure,
                                    unsigned open) {
    const Sides sides = visible_sides(world_.scene, world_.scene.objects[id], rule_);
    if (sure != 0) {
      alignas(64) double t[most];
      const PlaneHits planes = hit_planes(rays_, TrianglePlane(vertices), sides, t);
      keep_nearer<any>(id, t, planes.hit & sure);
      unsigned doubtful = planes.open & sure;
      while (doubtful != 0) {
        const int lane = take_lane(doubtful);
        keep<any>(lane, id, hit_triangle_plane(query(lane), vertices, sides));
      }
    }
    while (open != 0) {
      const int lane = take_lane(open);
      keep<any>(lane, id, hit_triangle_exactly(query(lane), vertices, sides));
    }
  }

  /// The ray of a lane by itself, made when it is first needed.
  const RayQuery& query(int lane) {
    std::optional<RayQuery>& query = queries_[lane];
    if (!query)
      query.emplace(rays_.ray(lane), rays_.reach_error * 0x1p24f, has_triangles(world_.scene));
    return *query;
  }

  /// Keeps t of those of `lanes` where it is the nearest so far.
  template <bool any>
  HWY_INLINE void keep_nearer(std::uint32_t id, const double* t, unsigned lanes) {
    constexpr hn::Half<Floats> halves;
    unsigned nearer = 0, equal = 0;
    for (int i = 0; i < lane_count(); i += static_cast<int>(hn::Lanes(doubles))) {
      const DoubleV found = hn::Load(doubles, t + i), best = hn::Load(doubles, best_t_ + i);
      const unsigned here = bits_of(doubles, hn::Lt(found, best)) & lanes >> i;
      nearer |= here << i;
      equal |= bits_of(doubles, hn::Eq(found, best)) << i;
      hn::BlendedStore(found, mask_of(doubles, here), doubles, best_t_ + i);
      const auto reach = hn::Mul(hn::DemoteTo(halves, found), hn::Set(halves, hit_margin));
      hn::BlendedStore(reach, mask_of(halves, here), halves, walk_.reach + i);
    }
    constexpr hn::RebindToUnsigned<Floats> ids;
    hn::BlendedStore(hn::Set(ids, id), mask_of(ids, nearer), ids, best_object_);
    if (any) end_rays(nearer);
    for (equal &= lanes; equal != 0;) {
      const int lane = take_lane(equal);
      keep<any>(lane, id, t[lane]);
    }
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
  RayLanes rays_;
  PacketWalk walk_;
  Classes classes_;
  alignas(64) double best_t_[most];
  alignas(64) std::uint32_t best_object_[most];
  std::optional<RayQuery> queries_[most];
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
