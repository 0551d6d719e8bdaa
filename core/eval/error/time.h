#pragma once

#include "core/eval/error/judge.h"

namespace bspview {

/// Seconds that `kernel` takes for the rays, after a few of them untimed: another tree may lie in
/// the caches. With one thread: processor time of the calling thread, which other programs on the
/// machine do not add to; with more: wall-clock time.
double time_rays(const BoundKernel& kernel, const RayBatch& batch, int threads);

/// Whether this machine tells processor times; else time_rays is wall-clock time throughout.
bool has_processor_time();

}  // namespace bspview
