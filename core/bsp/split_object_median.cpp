// The plane leaves as many objects on its left as on its right: the median of the edges of all
// boxes on one axis. (The median of the centres would cut the object that it comes from.)

#include "core/bsp/box_list.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

/// On the longest axis on which the median divides anything.
std::optional<Split> balance(const BuildJob& job, std::span<const ObjectPart> parts,
                             const Place& place) {
  for (const int axis : axes_by_length(place.cell)) {
    const float median = object_median(parts, axis);
    if (!PlaneRange(job, place.cell, axis).holds(median)) continue;
    const Split split = count_sides(job, parts, axis, median);
    if (divides(split, parts.size())) return split;
  }
  return {};
}

}  // namespace

void grow_object_median(const BuildJob& job, ObjectParts parts, Branch& branch) {
  BoxList objects(job, balance, std::move(parts));
  Recursion<BoxList>(job).grow_root(objects, branch);
}

}  // namespace bspview
