#include "core/bsp/build_job.h"

#include "core/math/float_error.h"

namespace bspview {

PlaneRange::PlaneRange(const BuildJob& job, const Aabb& cell, int axis) {
  const float lo = cell.lo[axis];
  const float hi = cell.hi[axis];
  first_ = std::max(round_up(lo + job.min_width), next_up(lo));
  last_ = std::min(round_down(hi - job.min_width), next_down(hi));
}

Aabb clipped_box(const BuildJob& job, std::uint32_t object, const Aabb& cell) {
  return intersection(job.input.clip(object, cell), cell);
}

}  // namespace bspview
