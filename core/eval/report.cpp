#include "core/eval/report.h"

#include "core/base/parallel.h"

namespace bspview {

TreeReport::TreeReport(const Tree& tree, Traversal how)
    : params(tree.params),
      traversal(how),
      memory_limit_reached(tree.memory_limit_reached),
      bytes(tree.bytes()),
      stats(tree_stats(tree)) {
  params.max_depth = tree.max_depth;
  params.cost_intersection = tree.cost_intersection;
  params.clip = effective_clip(tree.params);
  params.threads = thread_count(tree.params.threads);
  unbuilt_leaves = tree.unbuilt.size();
  for (const std::uint32_t leaf : tree.unbuilt) unbuilt_references += tree.nodes[leaf].count();
}

Report::Report(const Scene& scene)
    : scene_name(scene.name), objects(count_objects(scene)), bounds(scene_bounds(scene)) {}

}  // namespace bspview
