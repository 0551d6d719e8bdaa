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

/// Rays that were asked about together, in the tree of the accelerator.
std::uint64_t walk_together(const World& world, std::span<const RecordedRay> recorded,
                            Replay what) {
  std::vector<Ray> rays;
  for (const RecordedRay& one : recorded) {
    rays.push_back(one.ray);
    rays.back().t_max = one.end;
  }
  return walk_together(world, rays, what == Replay::walk);
}

std::uint64_t walk_wide(const World& world, std::span<const RecordedRay> rays, Replay what) {
  std::uint64_t sum = 0;
  while (!rays.empty()) {
    const auto is_first = [](const RecordedRay& one) { return one.is_first; };
    const auto behind = std::find_if(rays.begin() + 1, rays.end(), is_first);
    const auto wave = rays.first(static_cast<std::size_t>(behind - rays.begin()));
    sum += walk_together(world, wave, what);
    rays = rays.subspan(wave.size());
  }
  return sum;
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
  const auto replay_chunk = [&](int chunk) {
    if (stop.stop_requested()) return;
    const std::size_t first = static_cast<std::size_t>(chunk) * rays_a_chunk;
    const auto part = rays.subspan(first, std::min(rays_a_chunk, rays.size() - first));
    std::uint64_t sum = 0;
    if (wide) sum = walk_wide(world, part, what);
    for (const RecordedRay& ray : wide ? part.first(0) : part) {
      sum +=
          what == Replay::walk ? walk(world.tree, params.traversal, ray) : enter(world.tree, ray);
    }
    sums[static_cast<std::size_t>(chunk)] = sum;
  };
  with_threads(params.threads, [&] { parallel_for(static_cast<int>(chunks), replay_chunk); });
  std::uint64_t sum = 0;
  for (const std::uint64_t part : sums) sum += part;
  return sum;
}

}  // namespace bspview
