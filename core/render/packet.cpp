#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/packet.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include <bit>
#include <optional>

#include "core/bsp/traverse_packet-inl.h"
#include "core/render/packet.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {
namespace {

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
  /// others are no rays, start before their origin, or have a length whose reciprocal could
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
      best_[lane] = {};
      queries_[lane].reset();
    }
    find_reach();
    classes_ = find_classes();
    enter_root();
    return find_plain_rays() & ((1u << count) - 1u);
  }

  /// Lanes whose rays run the same way.
  struct Class {
    unsigned lanes;
    int main_axis;
    unsigned negative;  ///< bit axis
  };
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
    traverse_packet(world_.tree, walk_, [&](const Node& node, unsigned passing) {
      for (const std::uint32_t id : world_.tree.objects_of(node)) {
        passing &= rays_.active;
        if (passing == 0) return;
        meet<any>(id, passing);
      }
    });
  }

  const Hit& best(int lane) const { return best_[lane]; }

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
      plain = hn::And(plain, hn::Lt(hn::Abs(load(rays_.origin[axis])), infinity));
      largest = hn::Max(largest, size);
    }
    return bits_of(floats, hn::And(plain, hn::Gt(largest, all(0x1p-20f))));
  }

  void find_reach() {
    FloatV reach = hn::Zero(floats);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV origin = load(rays_.origin[axis]);
      const FloatV below = hn::Abs(hn::Sub(all(world_.tree.box.lo[axis]), origin));
      const FloatV above = hn::Abs(hn::Sub(all(world_.tree.box.hi[axis]), origin));
      reach = hn::Max(reach, hn::Max(below, above));
    }
    rays_.reach_error = unit_roundoff * hn::GetLane(hn::MaxOfLanes(floats, reach));
  }

  /// The intervals in the root, as root_interval, and the reciprocals.
  void enter_root() {
    FloatV enter = load(rays_.t_min), exit = load(rays_.t_max);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV inverse = hn::Div(all(1.0f), load(rays_.direction[axis]));
      const FloatV origin = load(rays_.origin[axis]);
      hn::Store(hn::Mul(inverse, all(1.0f - plane_error)), floats, walk_.sooner[axis]);
      hn::Store(hn::Mul(inverse, all(1.0f + plane_error)), floats, walk_.later[axis]);
      const Aabb& box = world_.tree.box;
      const FloatV a = hn::Mul(hn::Sub(all(box.lo[axis]), origin), inverse);
      const FloatV b = hn::Mul(hn::Sub(all(box.hi[axis]), origin), inverse);
      const auto is_number = hn::Not(hn::Or(hn::IsNaN(a), hn::IsNaN(b)));
      const FloatV near = hn::Min(a, b), far = hn::Max(a, b);
      const FloatV sooner = hn::Sub(near, hn::Mul(all(plane_error), hn::Abs(near)));
      const FloatV later = hn::Add(far, hn::Mul(all(plane_error), hn::Abs(far)));
      enter = hn::IfThenElse(hn::And(is_number, hn::Gt(sooner, enter)), sooner, enter);
      exit = hn::IfThenElse(hn::And(is_number, hn::Lt(later, exit)), later, exit);
    }
    hn::Store(enter, floats, enter_);
    hn::Store(exit, floats, exit_);
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
    walk_.negative = rays.negative;
    for (int lane = 0; lane < lane_count(); ++lane) {
      const bool takes_part = rays.lanes >> lane & 1u;
      walk_.enter[lane] = takes_part ? enter_[lane] : inf;
      walk_.exit[lane] = takes_part ? exit_[lane] : -inf;
      walk_.reach[lane] = inf;
    }
  }

  template <bool any>
  HWY_INLINE void meet(std::uint32_t id, unsigned lanes) {
    const Object& object = world_.scene.objects[id];
    if (object.kind == ObjectKind::triangle) {
      const Face& face = world_.scene.faces[object.shape];
      meet_triangle<any>(id, &world_.scene.vertices[face.first_vertex], lanes);
      return;
    }
    while (lanes != 0) {
      const int lane = take_lane(lanes);
      keep<any>(lane, id, hit_object(world_.scene, id, query(lane), rule_));
    }
  }

  template <bool any>
  HWY_INLINE void meet_triangle(std::uint32_t id, const Vec3* vertices, unsigned lanes) {
    const Insides insides = find_insides(rays_, vertices);
    const unsigned sure = insides.sure & lanes, open = insides.open & lanes;
    if ((sure | open) != 0) settle_triangle<any>(id, vertices, sure, open);
  }

  template <bool any>
  HWY_NOINLINE void settle_triangle(std::uint32_t id, const Vec3* vertices, unsigned sure,
                                    unsigned open) {
    const Sides sides = visible_sides(world_.scene, world_.scene.objects[id], rule_);
    if (sure != 0) {
      alignas(64) double t[most];
      const PlaneHits planes = hit_planes(rays_, TrianglePlane(vertices), sides, t);
      unsigned hit = planes.hit & sure, doubtful = planes.open & sure;
      while (hit != 0) {
        const int lane = take_lane(hit);
        keep<any>(lane, id, t[lane]);
      }
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

  template <bool any>
  HWY_INLINE void keep(int lane, std::uint32_t id, double t) {
    Hit& best = best_[lane];
    if (t == no_hit || !(t < best.t || (t == best.t && id < best.object))) return;
    best = {t, id, no_leaf};
    if (any) {
      rays_.active &= ~(1u << lane);
      walk_.reach[lane] = -std::numeric_limits<float>::infinity();
    } else {
      walk_.reach[lane] = static_cast<float>(t) * (1.0f + 16.0f * plane_error);
    }
  }

  const World& world_;
  SideRule rule_;
  RayLanes rays_;
  PacketWalk walk_;
  alignas(64) float enter_[most], exit_[most];
  Classes classes_;
  Hit best_[most];
  std::optional<RayQuery> queries_[most];
};

Hit find_alone(const World& world, const Ray& ray, SideRule rule, bool any) {
  NoObserver none;
  const TraceRules rules{.sides = rule, .shadow_sides = rule};
  if (!any) return closest_hit(world, ray, rules, none);
  return {0.0, any_hit(world, ray, rules, none), no_leaf};
}

/// Fewer rays than this are faster one by one.
constexpr int fewest_together = 3;

/// Traces up to lane_count() rays; found(i, hit) takes the answers.
template <bool any, class Found>
void trace_some(Packet& packet, const World& world, std::span<const Ray> rays, SideRule rule,
                const Found& found) {
  unsigned together = world.tree.naive ? 0 : packet.load_rays(rays);
  for (unsigned open = together; open != 0;) {
    const Packet::Class next = packet.class_among(open);
    open &= ~next.lanes;
    if (std::popcount(next.lanes) < fewest_together) {
      together &= ~next.lanes;
    } else {
      packet.trace<any>(next);
    }
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool is_done = together >> i & 1u;
    found(i, is_done ? packet.best(static_cast<int>(i)) : find_alone(world, rays[i], rule, any));
  }
}

template <bool any, class Found>
void trace_all(const World& world, std::span<const Ray> rays, SideRule rule, const Found& found) {
  Packet packet(world, rule);
  const auto width = static_cast<std::size_t>(lane_count());
  for (std::size_t first = 0; first < rays.size(); first += width) {
    const auto some = rays.subspan(first, std::min(width, rays.size() - first));
    trace_some<any>(packet, world, some, rule,
                    [&](std::size_t i, const Hit& hit) { found(first + i, hit); });
  }
}

void closest_hits_here(const World& world, std::span<const Ray> rays, SideRule rule,
                       std::span<Hit> hits) {
  trace_all<false>(world, rays, rule, [&](std::size_t i, const Hit& hit) {
    hits[i] = hit;
    hits[i].leaf = no_leaf;
  });
}

void any_hits_here(const World& world, std::span<const Ray> rays, SideRule rule,
                   std::span<std::uint32_t> objects) {
  trace_all<true>(world, rays, rule,
                  [&](std::size_t i, const Hit& hit) { objects[i] = hit.object; });
}

int width_here() {
  return lane_count();
}
const char* instructions_here() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(closest_hits_here);
HWY_EXPORT(any_hits_here);
HWY_EXPORT(width_here);
HWY_EXPORT(instructions_here);

void closest_hits(const World& world, std::span<const Ray> rays, SideRule rule,
                  std::span<Hit> hits) {
  HWY_DYNAMIC_DISPATCH(closest_hits_here)(world, rays, rule, hits);
}

void any_hits(const World& world, std::span<const Ray> rays, SideRule rule,
              std::span<std::uint32_t> objects) {
  HWY_DYNAMIC_DISPATCH(any_hits_here)(world, rays, rule, objects);
}

int packet_width() {
  return HWY_DYNAMIC_DISPATCH(width_here)();
}

const char* packet_instructions() {
  return HWY_DYNAMIC_DISPATCH(instructions_here)();
}

}  // namespace bspview
#endif
