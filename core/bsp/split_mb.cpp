// After MacDonald & Booth 1990, "Heuristics for ray tracing using space subdivision": on each axis
// the cheapest plane lies between the spatial median and the object median of the cell.

#include "core/bsp/box_list.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

constexpr int planes_between = 10;

std::optional<Split> cheapest_between_medians(const BuildJob& job,
                                              std::span<const ObjectPart> parts,
                                              const Place& place) {
  std::optional<Split> best;
  for (int axis = 0; axis < 3; ++axis) {
    const PlaneRange range(job, place.cell, axis);
    const SplitTests tests(job.costs, place.cell, axis);
    const double spatial = 0.5 * (double{place.cell.lo[axis]} + place.cell.hi[axis]);
    const double step = (object_median(parts, axis) - spatial) / (planes_between + 1);
    for (int i = 0; i <= planes_between + 1; ++i) {
      const auto position = static_cast<float>(spatial + i * step);
      if (!range.holds(position)) break;
      Split split = count_sides(job, parts, axis, position);
      split.tests = tests(position, split.left, split.right);
      if (divides(split, parts.size()) && (!best || split.tests < best->tests)) best = split;
    }
  }
  return best;
}

}  // namespace

void grow_mb(const BuildJob& job, ObjectParts parts, Branch& branch) {
  BoxList objects(job, cheapest_between_medians, std::move(parts));
  Recursion<BoxList>(job).grow_root(objects, branch);
}

}  // namespace bspview
