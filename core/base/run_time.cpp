#include "core/base/run_time.h"

#include <time.h>

#include <optional>

#include "core/base/parallel.h"
#include "core/base/timer.h"

namespace bspview {
namespace {

/// Of the calling thread.
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

double time_run(int threads, const std::function<void()>& work) {
  double seconds = 0.0;
  with_threads(threads, [&] {
    const Timer timer;
    const auto start = processor_seconds();
    work();
    const auto end = processor_seconds();
    seconds = threads == 1 && start && end ? *end - *start : timer.seconds();
  });
  return seconds;
}

}  // namespace bspview
