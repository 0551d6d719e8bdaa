#include "core/eval/error/time.h"

#include <time.h>

#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/timer.h"

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

std::optional<double> processor_seconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec now{};
  if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0) {
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
#endif
  return std::nullopt;
}

}  // namespace

bool has_processor_time() {
  return processor_seconds().has_value();
}

double time_rays(const BoundKernel& kernel, const RayBatch& batch, int threads) {
  const std::span rays(batch.rays);
  const auto trace_chunk = [&](std::size_t chunk) {
    const std::size_t first = chunk * rays_a_chunk;
    trace(kernel, batch.group, rays.subspan(first, std::min(rays_a_chunk, rays.size() - first)));
  };
  const std::size_t chunks = (rays.size() + rays_a_chunk - 1) / rays_a_chunk;
  if (chunks > 0) trace_chunk(0);
  if (threads == 1 && has_processor_time()) {
    const double start = *processor_seconds();
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) trace_chunk(chunk);
    return *processor_seconds() - start;
  }
  double seconds = 0.0;
  with_threads(threads, [&] {
    const Timer timer;
    parallel_for(static_cast<int>(chunks),
                 [&](int i) { trace_chunk(static_cast<std::size_t>(i)); });
    seconds = timer.seconds();
  });
  return seconds;
}

}  // namespace bspview
