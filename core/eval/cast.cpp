#include "core/eval/cast.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/parallel.h"
#include "core/render/hits.h"

namespace bspview {
namespace {

constexpr std::size_t rays_a_chunk = 4096;

RayResult cast_ray(const World& world, const Ray& ray, const CastParams& params) {
  const TraceRules rules{params.traversal, SideRule::two_sided};
  NoObserver none;
  if (params.query == CastParams::Query::any) {
    const std::uint32_t object = any_hit(world, ray, rules, none);
    return object == no_index ? RayResult{} : RayResult{object, 0.0};
  }
  const Hit hit = closest_hit(world, ray, rules, none);
  return {hit.object, hit.t};
}

void cast_packets(const World& world, std::span<const Ray> rays, CastParams::Query query,
                  std::span<RayResult> results) {
  if (query == CastParams::Query::any) {
    std::vector<std::uint32_t> objects(rays.size());
    any_hits(world, rays, SideRule::two_sided, objects);
    std::ranges::transform(objects, results.begin(), [](std::uint32_t object) {
      return object == no_index ? RayResult{} : RayResult{object, 0.0};
    });
    return;
  }
  std::vector<Hit> hits(rays.size());
  closest_hits(world, rays, SideRule::two_sided, hits);
  std::ranges::transform(hits, results.begin(), [](const Hit& hit) {
    return RayResult{hit.object, hit.t};
  });
}

}  // namespace

std::vector<RayResult> cast_rays(const World& world, std::span<const Ray> rays,
                                 const CastParams& params,
                                 const std::function<void(std::size_t)>& progress) {
  std::vector<RayResult> results(rays.size());
  const auto cast_chunk = [&](int chunk) {
    const std::size_t first = static_cast<std::size_t>(chunk) * rays_a_chunk;
    const std::size_t end = std::min(first + rays_a_chunk, rays.size());
    if (world.accelerator != nullptr && params.traversal == Traversal::robust) {
      const auto part = std::span(results).subspan(first, end - first);
      cast_packets(world, rays.subspan(first, end - first), params.query, part);
    } else {
      for (std::size_t i = first; i < end; ++i) results[i] = cast_ray(world, rays[i], params);
    }
    if (progress) progress(end - first);
  };
  const std::size_t chunks = (rays.size() + rays_a_chunk - 1) / rays_a_chunk;
  with_threads(params.threads, [&] { parallel_for(static_cast<int>(chunks), cast_chunk); });
  return results;
}

std::string cast_kernel(const World& world, const CastParams& params) {
  if (world.accelerator == nullptr || params.traversal != Traversal::robust) {
    return "one ray at a time";
  }
  return fmt::format("up to {} rays at a time ({})", packet_width(), packet_instructions());
}

}  // namespace bspview
