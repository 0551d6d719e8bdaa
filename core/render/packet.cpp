#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/packet.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

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

  /// Takes `count` rays in.
  void load_rays(const Ray* rays, int count) {
    float reach = 0.0f;
    for (int lane = 0; lane < lane_count(); ++lane) {
      const Ray& ray = rays[std::min(lane, count - 1)];
      for (int axis = 0; axis < 3; ++axis) {
        rays_.origin[axis][lane] = component(ray.origin, axis);
        rays_.direction[axis][lane] = component(ray.direction, axis);
      }
      rays_.t_min[lane] = ray.t_min;
      rays_.t_max[lane] = ray.t_max;
      best_[lane] = {};
      queries_[lane].reset();
      reach = std::max(reach, reach_of(world_.tree.box, ray.origin));
    }
    rays_.reach_error = reach * unit_roundoff;
    enter_root();
  }

  /// Finds what the rays of `lanes` hit: the nearest, or anything.
  template <bool any>
  void trace(unsigned lanes, int main_axis, unsigned negative) {
    set_class(lanes, main_axis, negative);
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
  /// The intervals in the root, as root_interval, and the reciprocals.
  void enter_root() {
    constexpr float error = PacketWalk::plane_error;
    FloatV enter = load(rays_.t_min), exit = load(rays_.t_max);
    for (int axis = 0; axis < 3; ++axis) {
      const FloatV inverse = hn::Div(all(1.0f), load(rays_.direction[axis]));
      const FloatV origin = load(rays_.origin[axis]);
      hn::Store(hn::Mul(inverse, all(1.0f - error)), floats, walk_.sooner[axis]);
      hn::Store(hn::Mul(inverse, all(1.0f + error)), floats, walk_.later[axis]);
      const Aabb& box = world_.tree.box;
      const FloatV a = hn::Mul(hn::Sub(all(box.lo[axis]), origin), inverse);
      const FloatV b = hn::Mul(hn::Sub(all(box.hi[axis]), origin), inverse);
      const auto is_number = hn::Not(hn::Or(hn::IsNaN(a), hn::IsNaN(b)));
      const FloatV near = hn::Min(a, b), far = hn::Max(a, b);
      const FloatV sooner = hn::Sub(near, hn::Mul(all(error), hn::Abs(near)));
      const FloatV later = hn::Add(far, hn::Mul(all(error), hn::Abs(far)));
      enter = hn::IfThenElse(hn::And(is_number, hn::Gt(sooner, enter)), sooner, enter);
      exit = hn::IfThenElse(hn::And(is_number, hn::Lt(later, exit)), later, exit);
    }
    hn::Store(enter, floats, enter_);
    hn::Store(exit, floats, exit_);
  }

  void set_class(unsigned lanes, int main_axis, unsigned negative) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    rays_.kz = main_axis;
    rays_.kx = main_axis == 2 ? 0 : main_axis + 1;
    rays_.ky = rays_.kx == 2 ? 0 : rays_.kx + 1;
    const FloatV z = load(rays_.direction[rays_.kz]);
    hn::Store(hn::Div(load(rays_.direction[rays_.kx]), z), floats, rays_.shear_x);
    hn::Store(hn::Div(load(rays_.direction[rays_.ky]), z), floats, rays_.shear_y);
    rays_.active = lanes;
    walk_.negative = negative;
    for (int lane = 0; lane < lane_count(); ++lane) {
      const bool takes_part = lanes >> lane & 1u;
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
    if (!query) query.emplace(rays_.ray(lane), rays_.reach_error * 0x1p24f);
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
      walk_.reach[lane] = static_cast<float>(t) * (1.0f + 16.0f * PacketWalk::plane_error);
    }
  }

  const World& world_;
  SideRule rule_;
  RayLanes rays_;
  PacketWalk walk_;
  alignas(64) float enter_[most], exit_[most];
  Hit best_[most];
  std::optional<RayQuery> queries_[most];
};

/// Rays that a packet can hold together have the same class; those of class `alone` go by
/// themselves: what is no ray, t_min < 0, lengths whose reciprocals could overflow.
constexpr unsigned alone = ~0u;
HWY_INLINE unsigned class_of(const Ray& ray) {
  const Vec3 size = glm::abs(ray.direction);
  const float largest = largest_component(size);
  const Vec3 finite = 0.0f * ray.origin;
  const bool is_plain = largest > 0x1p-20f && largest < 0x1p20f && finite == Vec3(0.0f) &&
                        size.x + size.y + size.z < 0x1p22f && ray.t_min >= 0.0f &&
                        ray.t_min < ray.t_max;
  if (!is_plain) return alone;
  const unsigned axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const Vec3 d = ray.direction;
  return axis << 3 | unsigned{std::signbit(d.x)} | unsigned{std::signbit(d.y)} << 1 |
         unsigned{std::signbit(d.z)} << 2;
}

Hit find_alone(const World& world, const Ray& ray, SideRule rule, bool any) {
  NoObserver none;
  const TraceRules rules{.sides = rule, .shadow_sides = rule};
  if (!any) return closest_hit(world, ray, rules, none);
  return {0.0, any_hit(world, ray, rules, none), no_leaf};
}

/// Traces up to lane_count() rays; found(i, hit) takes the answers.
template <bool any, class Found>
void trace_some(Packet& packet, const World& world, std::span<const Ray> rays, SideRule rule,
                const Found& found) {
  unsigned classes[most];
  unsigned remaining = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    classes[i] = world.tree.naive ? alone : class_of(rays[i]);
    if (classes[i] == alone) {
      found(i, find_alone(world, rays[i], rule, any));
    } else {
      remaining |= 1u << i;
    }
  }
  if (remaining == 0) return;
  packet.load_rays(rays.data(), static_cast<int>(rays.size()));
  const unsigned traced = remaining;
  while (remaining != 0) {
    const unsigned one = classes[__builtin_ctz(remaining)];
    unsigned lanes = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) lanes |= (classes[i] == one ? 1u : 0u) << i;
    packet.trace<any>(lanes, static_cast<int>(one >> 3), one & 7u);
    remaining &= ~lanes;
  }
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (traced >> i & 1u) found(i, packet.best(static_cast<int>(i)));
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
                   std::span<char> hits) {
  trace_all<true>(world, rays, rule, [&](std::size_t i, const Hit& hit) { hits[i] = hit ? 1 : 0; });
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

void any_hits(const World& world, std::span<const Ray> rays, SideRule rule, std::span<char> hits) {
  HWY_DYNAMIC_DISPATCH(any_hits_here)(world, rays, rule, hits);
}

int packet_width() {
  return HWY_DYNAMIC_DISPATCH(width_here)();
}

const char* packet_instructions() {
  return HWY_DYNAMIC_DISPATCH(instructions_here)();
}

}  // namespace bspview
#endif
