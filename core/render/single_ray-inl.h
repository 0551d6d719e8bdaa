// Hits of one ray by the wide tree. Included once for every instruction set that Highway
// (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_SINGLE_RAY) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_SINGLE_RAY
#undef BSPVIEW_SINGLE_RAY
#else
#define BSPVIEW_SINGLE_RAY
#endif

#include <optional>
#include <type_traits>

#include "core/render/accelerator.h"
#include "core/render/intersect.h"
#include "core/render/traverse_parts-inl.h"
#include "core/shape/triangle_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// Whether the wide tree can take a ray: none that starts before its origin, is no ray, or has a
/// component other than 0 whose reciprocal could overflow.
HWY_INLINE bool is_plain(const Ray& ray) {
  const Vec3 sizes = magnitudes(ray.direction);
  const float size = largest_component(sizes);
  for (int axis = 0; axis < 3; ++axis) {
    if (sizes[axis] < std::numeric_limits<float>::min() && sizes[axis] != 0.0f) return false;
  }
  const Vec3 zero = 0.0f * (ray.origin + ray.direction);
  return size > 0x1p-20f && size < 0x1p20f && zero == Vec3(0.0f) && ray.t_min >= 0.0f &&
         ray.t_min < ray.t_max;
}

/// What triangles need of a ray, with the names of RayQuery: most rays need no more of it.
struct TriangleRay : RayShear {
  HWY_INLINE TriangleRay(const Ray& ray, float reach)
      : RayShear(ray),
        wide_origin(ray.origin),
        wide_direction(ray.direction),
        t_min(ray.t_min),
        t_max(ray.t_max),
        reach_error(reach * unit_roundoff) {}

  Vec3d wide_origin, wide_direction;
  double t_min, t_max;
  float reach_error;
};

/// A ray in a scene without triangles.
struct NoTriangleRay {
  HWY_INLINE NoTriangleRay(const Ray&, float) {}
};

/// One ray on its way: to anything, or to the nearest; in a scene with triangles, or without.
template <bool any, bool triangles>
class SingleRay {
 public:
  HWY_INLINE SingleRay(const World& world, const Ray& ray, SideRule rule)
      : world_(world),
        rule_(rule),
        sees_backs_(rule == SideRule::two_sided || world.scene.two_sided),
        ray_(ray),
        triangle_ray_(ray, reach_of(world.tree.box, ray.origin)),
        reach_(ray.t_max * hit_margin) {}

  HWY_INLINE Hit trace() {
    const auto meet = [&](const Accelerator& accelerator, std::uint32_t child) {
      meet_leaf(accelerator, child);
    };
    traverse_parts(*world_.accelerator, WideRay(ray_), reach_, meet);
    return best_;
  }

 private:
  HWY_INLINE void meet_leaf(const Accelerator& accelerator, std::uint32_t child) {
    const WideLeaf leaf = accelerator.leaf(child);
    if constexpr (triangles) {
      for_some_blocks(accelerator.blocks(leaf), [&](auto blocks) { meet_blocks(blocks); });
    }
    if (leaf.other_count != 0 && !(any && best_)) meet_others(accelerator, leaf);
  }

  HWY_INLINE void meet_blocks(std::span<const TriangleBlock> blocks) {
    if (any && best_) return;
    BlocksHits hits = find_triangles(triangle_ray_, blocks);
    while (hits.possible != 0) {
      const int first = __builtin_ctzll(hits.possible) & ~(TriangleBlock::width - 1);
      meet_triangles(blocks[static_cast<std::size_t>(first / TriangleBlock::width)],
                     {static_cast<std::uint8_t>(hits.possible >> first),
                      static_cast<std::uint8_t>(hits.sure >> first)});
      if (any && best_) return;
      hits.possible &= ~(std::uint64_t{0xff} << first);
    }
  }

  HWY_INLINE void meet_others(const Accelerator& accelerator, const WideLeaf& leaf) {
    for (const LeafObject& object : accelerator.others(leaf)) {
      keep(object.id,
           hit_shape(world_.scene, object.kind(), object.shape, query(), sides_of(object.id)));
      if (any && best_) return;
    }
  }

  HWY_INLINE void meet_triangles(const TriangleBlock& block, BlockHits hits) {
    BlockPlanes planes;
    if (hits.sure != 0) find_planes(triangle_ray_, block, hits.sure, planes);
    for (unsigned rest = planes.hit & hits.sure; rest != 0; rest &= rest - 1) {
      const int slot = __builtin_ctz(rest);
      const std::uint32_t id = block.object[slot];
      const bool is_behind = (planes.behind >> slot & 1u) != 0;
      if (is_behind && !sees_backs_ && sides_of(id) == Sides::front) continue;
      keep(id, planes.t[slot]);
    }
    const unsigned open = hits.possible & ~(hits.sure & ~planes.open);
    if (open != 0) meet_open_triangles(block, open, hits.sure);
  }

  HWY_NOINLINE void meet_open_triangles(const TriangleBlock& block, unsigned open, unsigned sure) {
    for (; open != 0; open &= open - 1) {
      const int slot = __builtin_ctz(open);
      Vec3 vertices[3];
      for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) vertices[i][axis] = block.vertices[i][axis][slot];
      }
      const std::uint32_t id = block.object[slot];
      const bool passes_through = (sure >> slot & 1u) != 0;
      keep(id, passes_through ? hit_triangle_plane(query(), vertices, sides_of(id))
                              : hit_triangle_exactly(query(), vertices, sides_of(id)));
    }
  }

  Sides sides_of(std::uint32_t id) const {
    return visible_sides(world_.scene, world_.scene.objects[id], rule_);
  }

  HWY_INLINE void keep(std::uint32_t id, double t) {
    if (t == no_hit || !(t < best_.t || (t == best_.t && id < best_.object))) return;
    best_ = {t, id, no_leaf};
    reach_ = any ? -1.0f : static_cast<float>(t) * hit_margin;
  }

  /// In place: what is copied as soon as it was written waits for its pieces.
  HWY_NOINLINE void make_query() {
    query_.emplace(ray_, reach_of(world_.tree.box, ray_.origin), triangles);
  }
  HWY_INLINE const RayQuery& query() {
    if (!query_) make_query();
    return *query_;
  }

  const World& world_;
  const SideRule rule_;
  const bool sees_backs_;
  const Ray& ray_;
  const std::conditional_t<triangles, TriangleRay, NoTriangleRay> triangle_ray_;
  std::optional<RayQuery> query_;
  Hit best_;
  float reach_;
};

/// The nearest hit, or anything.
template <bool any>
HWY_INLINE Hit trace_single_ray(const World& world, const Ray& ray, SideRule rule) {
  if (has_triangles(world.scene)) return SingleRay<any, true>(world, ray, rule).trace();
  return SingleRay<any, false>(world, ray, rule).trace();
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
