#pragma once

#include <array>
#include <span>

#include "core/bsp/build_job.h"
#include "core/bsp/scratch_stack.h"

namespace bspview {

/// Chooses the plane of a node from the boxes of its objects; nullopt: the node is a leaf.
using SplitRule = std::optional<Split> (*)(const BuildJob&, std::span<const ObjectPart>,
                                           const Place&);

/// The objects of a node as boxes, for the rules that look at them anew in every node.
class BoxList {
 public:
  BoxList(const BuildJob& job, SplitRule rule, ObjectParts parts)
      : job_(&job), rule_(rule), parts_(std::move(parts)) {}

  std::size_t count() const { return parts_.size(); }
  void write_objects(std::uint32_t* to) const;
  std::optional<Split> find_split(const Place& place) const { return rule_(*job_, parts_, place); }
  BoxList split(const CellSplit& split, ScratchStack& scratch);
  void release() { parts_ = {}; }
  std::span<const ObjectPart> parts() const { return parts_; }

 private:
  const BuildJob* job_;
  SplitRule rule_;
  ObjectParts parts_;
};

/// The plane with the number of parts that touch each side.
Split count_sides(const BuildJob& job, std::span<const ObjectPart> parts, int axis, float position);

/// Whether at least one side of the plane is touched by fewer than all of the node's `count` parts.
bool divides(const Split& split, std::size_t count);

/// The plane that as many parts touch from the left as from the right: the median of all edges,
/// each moved outwards by one float so that the plane does not cut the part it comes from.
/// Very many parts are represented by every k-th.
float object_median(std::span<const ObjectPart> parts, int axis);

/// Axes of `cell` from the longest to the shortest, the lower one first among equals.
std::array<int, 3> axes_by_length(const Aabb& cell);

}  // namespace bspview
