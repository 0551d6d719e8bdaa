// Hits of one ray by the wide tree. Included once for every instruction set that Highway
// (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_SINGLE_RAY) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_SINGLE_RAY
#undef BSPVIEW_SINGLE_RAY
#else
#define BSPVIEW_SINGLE_RAY
#endif

#include "core/bsp/traverse_wide-inl.h"
#include "core/render/accelerator.h"
#include "core/render/intersect.h"
#include "core/shape/triangle_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

/// Whether the wide tree can take a ray: none that starts before its origin, is no ray, or has a
/// direction whose reciprocal could overflow.
HWY_INLINE bool is_plain(const Ray& ray) {
  const float size = largest_component(glm::abs(ray.direction));
  const Vec3 zero = 0.0f * (ray.origin + ray.direction);
  return size > 0x1p-20f && size < 0x1p20f && zero == Vec3(0.0f) && ray.t_min >= 0.0f &&
         ray.t_min < ray.t_max;
}

/// One ray on its way.
template <bool any>
class SingleRay {
 public:
  HWY_INLINE SingleRay(const World& world, const Ray& ray, SideRule rule)
      : world_(world),
        rule_(rule),
        query_(ray, reach_of(world.tree.box, ray.origin), has_triangles(world.scene)),
        reach_(ray.t_max) {}

  /// visit() is told of each leaf.
  template <class Visit>
  HWY_INLINE Hit trace(const Ray& ray, Visit&& visit) {
    traverse_wide(world_.accelerator->tree(), WideRay(ray), reach_, [&](std::uint32_t child) {
      visit();
      meet_leaf(child);
    });
    return best_;
  }

 private:
  HWY_INLINE void meet_leaf(std::uint32_t child) {
    const WideLeaf leaf = world_.accelerator->leaf(child);
    const TriangleBlock* block = world_.accelerator->blocks() + leaf.first_block;
    for (std::uint32_t i = 0; i < leaf.block_count; ++i, ++block) {
      const BlockHits hits = find_triangles(query_, *block);
      if (hits.possible != 0) meet_triangles(*block, hits);
      if (any && best_) return;
    }
    for (const std::uint32_t id : world_.accelerator->others(leaf)) {
      keep(id, hit_object(world_.scene, id, query_, rule_));
      if (any && best_) return;
    }
  }

  HWY_INLINE void meet_triangles(const TriangleBlock& block, BlockHits hits) {
    for (; hits.possible != 0; hits.possible &= hits.possible - 1) {
      const int slot = __builtin_ctz(hits.possible);
      const std::uint32_t id = block.object[slot];
      Vec3 vertices[3];
      for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) vertices[i][axis] = block.vertices[i][axis][slot];
      }
      const Sides sides = visible_sides(world_.scene, world_.scene.objects[id], rule_);
      const bool is_sure = hits.sure >> slot & 1u;
      keep(id, is_sure ? hit_triangle_plane(query_, vertices, sides)
                       : hit_triangle_exactly(query_, vertices, sides));
      if (any && best_) return;
    }
  }

  HWY_INLINE void keep(std::uint32_t id, double t) {
    if (t == no_hit || !(t < best_.t || (t == best_.t && id < best_.object))) return;
    best_ = {t, id, no_leaf};
    reach_ = any ? -1.0f : static_cast<float>(t) * hit_margin;
  }

  const World& world_;
  const SideRule rule_;
  const RayQuery query_;
  Hit best_;
  float reach_;
};

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
