// After Havran, "Evaluation of BSP trees for ray-tracing": the plane halves the cell.

#include "core/bsp/box_list.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

std::optional<Split> halve(const BuildJob& job, std::span<const ObjectPart> parts, const Aabb& cell,
                           int axis) {
  const float middle = 0.5f * (cell.lo[axis] + cell.hi[axis]);
  if (!PlaneRange(job, cell, axis).holds(middle)) return {};
  return count_sides(job, parts, axis, middle);
}

std::optional<Split> halve_cyclic_axis(const BuildJob& job, std::span<const ObjectPart> parts,
                                       const Place& place) {
  return halve(job, parts, place.cell, place.depth % 3);
}

std::optional<Split> halve_longest_axis(const BuildJob& job, std::span<const ObjectPart> parts,
                                        const Place& place) {
  return halve(job, parts, place.cell, axes_by_length(place.cell)[0]);
}

}  // namespace

void grow_median(const BuildJob& job, ObjectParts parts, Branch& branch) {
  BoxList objects(job, halve_cyclic_axis, std::move(parts));
  Recursion<BoxList>(job).grow_root(objects, branch);
}

void grow_median_longest(const BuildJob& job, ObjectParts parts, Branch& branch) {
  BoxList objects(job, halve_longest_axis, std::move(parts));
  Recursion<BoxList>(job).grow_root(objects, branch);
}

}  // namespace bspview
