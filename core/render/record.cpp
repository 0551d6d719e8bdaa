#include "core/render/record.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

constexpr std::size_t rays_a_chunk = 4096;

std::uint64_t walk(const Tree& tree, Traversal traversal, const RecordedRay& recorded) {
  std::uint32_t left = recorded.leaves;
  const auto leaf = [&](std::uint32_t, const Node&) { return --left == 0 ? stop_walk : no_hit; };
  NoObserver none;
  return traverse(traversal, tree, recorded.ray, leaf, none);
}

/// The same in the tree of the accelerator.
std::uint64_t walk_wide(const World& world, const RecordedRay& recorded, Replay what) {
  if (recorded.leaves == 0 && what == Replay::walk) return 0;
  return walk_leaves(world, recorded.ray, what == Replay::walk ? recorded.leaves : 0);
}

std::uint64_t enter(const Tree& tree, const RecordedRay& recorded) {
  const RayInterval interval = root_interval(tree, RayWalk(recorded.ray));
  return interval.enter <= interval.exit;
}

}  // namespace

std::uint64_t replay(const World& world, const RenderParams& params,
                     std::span<const RecordedRay> rays, Replay what, std::stop_token stop) {
  const std::size_t chunks = (rays.size() + rays_a_chunk - 1) / rays_a_chunk;
  std::vector<std::uint64_t> sums(chunks);
  const bool wide = is_fast(world, trace_rules(params));
  const auto replay_one = [&](const RecordedRay& ray) -> std::uint64_t {
    if (wide) return walk_wide(world, ray, what);
    return what == Replay::walk ? walk(world.tree, params.traversal, ray) : enter(world.tree, ray);
  };
  const auto replay_chunk = [&](int chunk) {
    if (stop.stop_requested()) return;
    const std::size_t first = static_cast<std::size_t>(chunk) * rays_a_chunk;
    const auto part = rays.subspan(first, std::min(rays_a_chunk, rays.size() - first));
    std::uint64_t sum = 0;
    for (const RecordedRay& ray : part) sum += replay_one(ray);
    sums[static_cast<std::size_t>(chunk)] = sum;
  };
  with_threads(params.threads, [&] { parallel_for(static_cast<int>(chunks), replay_chunk); });
  std::uint64_t sum = 0;
  for (const std::uint64_t part : sums) sum += part;
  return sum;
}

}  // namespace bspview
