#include "core/eval/error/time.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/run_time.h"

namespace bspview {
namespace {

constexpr std::size_t rays_a_chunk = 4096;

void trace(const BoundKernel& kernel, RayGroup group, std::span<const Ray> rays) {
  thread_local std::vector<RayResult> results;
  thread_local std::vector<char> occluded;
  if (group == RayGroup::shadow) {
    occluded.resize(std::max(occluded.size(), rays.size()));
    kernel.occluded(rays, std::span(occluded).first(rays.size()));
  } else {
    results.resize(std::max(results.size(), rays.size()));
    kernel.closest(rays, std::span(results).first(rays.size()));
  }
}

}  // namespace

double time_rays(const BoundKernel& kernel, const RayBatch& batch, int threads) {
  const std::span rays(batch.rays);
  const auto trace_chunk = [&](std::size_t chunk) {
    const std::size_t first = chunk * rays_a_chunk;
    trace(kernel, batch.group, rays.subspan(first, std::min(rays_a_chunk, rays.size() - first)));
  };
  const std::size_t chunks = (rays.size() + rays_a_chunk - 1) / rays_a_chunk;
  if (chunks > 0) trace_chunk(0);
  return time_run(threads, [&] {
    parallel_for(static_cast<int>(chunks),
                 [&](int i) { trace_chunk(static_cast<std::size_t>(i)); });
  });
}

}  // namespace bspview
