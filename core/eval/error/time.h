#pragma once

#include "core/eval/error/judge.h"

namespace bspview {

/// Seconds that `kernel` takes for the rays by time_run, after a few of them untimed: another tree
/// may lie in the caches.
double time_rays(const BoundKernel& kernel, const RayBatch& batch, int threads);

}  // namespace bspview
