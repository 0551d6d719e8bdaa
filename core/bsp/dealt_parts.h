#pragma once

#include <span>
#include <vector>

#include "core/bsp/build_job.h"
#include "core/bsp/node.h"

namespace bspview {

/// What is dealt: parts of objects, or all placeable objects of a build, for which no list is made.
class PartsView {
 public:
  explicit PartsView(const BuildInput& input) : boxes_(input.boxes) {}
  explicit PartsView(std::span<const ObjectPart> parts) : parts_(parts) {}

  std::size_t size() const { return boxes_.size() + parts_.size(); }  // one of them has none
  ObjectPart operator[](std::size_t i) const {
    return parts_.empty() ? ObjectPart{boxes_[i], static_cast<std::uint32_t>(i)} : parts_[i];
  }
  const Aabb& box(std::size_t i) const { return parts_.empty() ? boxes_[i] : parts_[i].box; }

  /// In a list of their own.
  ObjectParts list(const BuildJob& job) const {
    return parts_.empty() ? placeable_objects(job) : ObjectParts(parts_.begin(), parts_.end());
  }

 private:
  std::span<const Aabb> boxes_;
  std::span<const ObjectPart> parts_;
};

/// A small tree whose leaves are numbered.
struct DealTree {
  Nodes nodes;              ///< a leaf's first reference is its number
  std::vector<Aabb> cells;  ///< of the nodes
  std::size_t leaf_count = 0;
};

/// For each leaf the parts of objects in it, in their order. Parts that lie on both sides of a
/// plane are clipped where the job says so. The same for any number of threads.
std::vector<ObjectParts> deal_parts(const BuildJob& job, const PartsView& parts,
                                    const DealTree& tree);

}  // namespace bspview
