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
#include "core/shape/round_lanes-inl.h"
#include "core/shape/shear_interval-inl.h"
#include "core/shape/triangle_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

constexpr int most = RayLanes::most;

/// So many rays meet a block one by one: what they pass as a whole is not worth finding out.
constexpr std::size_t few = 2;

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
  /// overflow, or a reach whose square could.
  unsigned load_rays(std::span<const Ray> rays) {
    const int count = static_cast<int>(rays.size());
    if (count == lane_count()) {
      transpose(rays.data());
    } else {
      Ray padded[most];
      std::fill(std::copy(rays.begin(), rays.end(), padded), std::end(padded), rays.back());
      transpose(padded);
    }
    std::fill_n(best_t_, most, no_hit);
    std::fill_n(best_object_, most, no_index);
    for (; has_query_ != 0;) queries_[take_lane(has_query_)].reset();
    classes_ = find_classes();
    const unsigned plain = find_plain_rays() & ((1u << count) - 1u);
    find_reach(plain);
    return rays_.reach_error < 0x1p30f ? plain : 0u;
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
  /// Takes in as many rays as there are lanes.
  HWY_INLINE void transpose(const Ray* rays) {
    float* const fields[] = {rays_.origin[0],    rays_.origin[1],    rays_.origin[2],
                             rays_.direction[0], rays_.direction[1], rays_.direction[2],
                             rays_.t_min,        rays_.t_max};
    static_assert(sizeof(Ray) == sizeof(fields) / sizeof(float*) * sizeof(float));
    const auto* const values = reinterpret_cast<const float*>(rays);
#if HWY_TARGET == HWY_SCALAR
    for (int i = 0; i < 8; ++i) *fields[i] = values[i];
#else
    FloatV low[4], high[4];
    hn::LoadInterleaved4(floats, values, low[0], low[1], low[2], low[3]);
    hn::LoadInterleaved4(floats, values + 4 * lane_count(), high[0], high[1], high[2], high[3]);
    for (int i = 0; i < 4; ++i) {
      hn::Store(hn::ConcatEven(floats, high[i], low[i]), floats, fields[i]);
      hn::Store(hn::ConcatOdd(floats, high[i], low[i]), floats, fields[4 + i]);
    }
#endif
  }

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
    const LaneVectors d = directions(rays_);
    hn::Store(hn::Sqrt(d.dot(d)), floats, rays_.length);
    rays_.active = rays.lanes;
    interval_ = ShearInterval(rays_, rays.lanes);
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
    for_some_blocks(accelerator.blocks(leaf),
                    [&](auto blocks) { meet_blocks<any>(blocks, lanes & rays_.active); });
    for (const LeafObject& object : accelerator.others(leaf)) {
      meet_object<any>(object, lanes & rays_.active);
    }
  }

  template <bool any>
  HWY_INLINE void meet_object(const LeafObject& object, unsigned lanes) {
    const Scene& scene = world_.scene;
    if (hwy::PopCount(lanes) > few) lanes &= lanes_near(object);
    while (lanes != 0) {
      const int lane = take_lane(lanes);
      keep<any>(lane, object.id,
                hit_shape(scene, object.kind(), object.shape, query(lane),
                          visible_sides(scene, scene.objects[object.id], rule_)));
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
    BlocksHits hits[most];
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
  RayLanes rays_;
  PacketWalk walk_;
  ShearInterval interval_;
  Classes classes_;
  alignas(64) double best_t_[most];
  alignas(64) std::uint32_t best_object_[most];
  std::optional<RayQuery> queries_[most];
  unsigned has_query_ = 0;
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
