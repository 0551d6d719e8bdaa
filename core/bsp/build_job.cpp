#include "core/bsp/build_job.h"

#include "core/math/float_error.h"

namespace bspview {

PlaneRange::PlaneRange(const BuildJob& job, const Aabb& cell, int axis)
    : first_(round_up(cell.lo[axis] + job.min_width)),
      last_(round_down(cell.hi[axis] - job.min_width)) {}

}  // namespace bspview
