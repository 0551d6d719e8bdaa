#include "core/render/lazy_walk.h"

#include <algorithm>

#include "core/render/lazy_tree.h"
#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

using Parts = std::span<const std::shared_ptr<const LazyPart>>;

class PartsWalk {
 public:
  PartsWalk(const World& world, const Ray& ray, SideRule rule, bool any)
      : scene_(world.scene),
        ray_(ray),
        query_(ExactShapes::query(world, ray)),
        rule_(rule),
        any_(any) {}

  /// The end of the walk so far: t of the best hit, or stop_walk.
  double walk(const Tree& tree, Parts parts) {
    NoObserver none;
    const auto leaf = [&](std::uint32_t index, const Node& node) {
      const auto part = std::ranges::lower_bound(
          parts, index, {}, [](const auto& candidate) { return candidate->node(); });
      if (part == parts.end() || (*part)->node() != index) return meet(tree.objects_of(node));
      const Tree* const below = (*part)->build();
      return below ? walk(*below, (*part)->parts()) : meet(tree.objects_of(node));
    };
    traverse(Traversal::robust, tree, ray_, leaf, none);
    return end_;
  }

  const Hit& best() const { return best_; }

 private:
  double meet(std::span<const std::uint32_t> objects) {
    for (const std::uint32_t id : objects) {
      const double t = hit_object(scene_, id, query_, rule_);
      if (t == no_hit || !(t < best_.t || (t == best_.t && id < best_.object))) continue;
      best_ = {t, id, no_leaf};
      end_ = any_ ? stop_walk : t;
      if (any_) break;
    }
    return end_;
  }

  const Scene& scene_;
  const Ray& ray_;
  const RayQuery query_;
  const SideRule rule_;
  const bool any_;
  Hit best_;
  double end_ = no_hit;
};

}  // namespace

Hit find_in_parts(const World& world, const Ray& ray, SideRule rule, bool any) {
  PartsWalk walk(world, ray, rule, any);
  walk.walk(world.tree, world.accelerator->parts());
  return walk.best();
}

Result<void> build_for_counts(const World& world, const Camera& camera, const RenderParams& params,
                              const Watch& watch) {
  const TraceRules rules = trace_rules(params);
  const auto closest = [&](const Ray& ray) {
    return find_in_parts(world, ray, rules.sides, false);
  };
  const auto is_occluded = [&](const Ray& ray) {
    return static_cast<bool>(find_in_parts(world, ray, rules.shadow_sides, true));
  };
  const auto eye_hits = [&](std::span<const Ray> rays, std::span<Hit> hits) {
    std::ranges::transform(rays, hits.begin(), closest);
  };
  const RayKernel kernel{eye_hits, closest, is_occluded};
  const auto image = render_with(world.scene, kernel, camera, params, watch);
  return image ? Result<void>() : image.error();
}

}  // namespace bspview
