#pragma once

#include <cstddef>
#include <functional>

namespace bspview {

/// Number of threads that `threads` asks for: itself, or every core when it is 0.
int thread_count(int threads);

/// Runs `work` where at most `threads` threads (0: every core) serve the parallel calls made in it.
void with_threads(int threads, const std::function<void()>& work);

/// Runs body(0) ... body(count - 1), in any order, on the threads of the enclosing with_threads.
void parallel_for(int count, const std::function<void(int)>& body);

/// Runs body(first, last) for ranges of `step` indices, the last one shorter, that together are 0
/// ... count - 1, in any order.
void parallel_ranges(std::size_t count, std::size_t step,
                     const std::function<void(std::size_t first, std::size_t last)>& body);

/// Runs both, possibly at the same time; returns when both are done.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second);

}  // namespace bspview
