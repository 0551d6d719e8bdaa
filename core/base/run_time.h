#pragma once

#include <functional>

namespace bspview {

/// Seconds that `work` takes, the parallel calls in it being served by `threads` threads (0: every
/// core). One thread: its processor time, which other programs on the machine do not add to. More
/// threads, or a system that does not tell: wall-clock time.
double time_run(int threads, const std::function<void()>& work);

}  // namespace bspview
