#include "core/base/parallel.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <optional>

namespace bspview {
namespace {

/// An exception in one of two parallel works must not cut short the loops inside the other, which
/// would go on with half of their results: each call is cancelled by its own exceptions only.
class Alone {
 public:
  tbb::task_group_context& operator*() { return context_; }

 private:
  tbb::task_group_context context_{tbb::task_group_context::isolated};
};

}  // namespace

int thread_count(int threads) {
  return threads > 0 ? threads : tbb::info::default_concurrency();
}

void with_threads(int threads, const std::function<void()>& work) {
  // More threads than cores have to be allowed explicitly.
  std::optional<tbb::global_control> more;
  if (threads > thread_count(0)) {
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena arena(thread_count(threads));
  arena.execute(work);
}

void parallel_for(int count, const std::function<void(int)>& body) {
  tbb::parallel_for(
      tbb::blocked_range<int>(0, count, 1),
      [&](const tbb::blocked_range<int>& range) {
        for (int i = range.begin(); i < range.end(); ++i) body(i);
      },
      tbb::simple_partitioner(), *Alone());
}

void parallel_ranges(std::size_t count, std::size_t step,
                     const std::function<void(std::size_t first, std::size_t last)>& body) {
  parallel_for(static_cast<int>((count + step - 1) / step), [&](int i) {
    const std::size_t first = static_cast<std::size_t>(i) * step;
    body(first, std::min(count, first + step));
  });
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
  tbb::parallel_invoke(first, second, *Alone());
}

}  // namespace bspview
