#pragma once

#include <span>
#include <vector>

#include "core/bsp/few_parts.h"

namespace bspview {

/// The objects of a node by their boxes, whose planes are priced by counting box sides in bins.
class BinnedParts {
 public:
  /// Keeps to the memory of `parts`, and writes there.
  BinnedParts(const BuildJob& job, std::span<ObjectPart> parts, ScratchStack& scratch)
      : job_(&job), count_(parts.size()), parts_(parts.data()), own_(scratch, 0) {}

  std::size_t count() const { return count_; }
  void write_objects(std::uint32_t* to) const;
  std::optional<Split> find_split(const Place& place) const;
  FewParts few_parts(ScratchStack& scratch) const;
  BinnedParts split(const CellSplit& split, ScratchStack& scratch);
  void release() { own_.release(); }
  std::span<const ObjectPart> parts() const { return {parts_, count_}; }

 private:
  BinnedParts(const BuildJob& job, std::size_t capacity, ScratchStack& scratch)
      : job_(&job), parts_(nullptr), own_(scratch, capacity) {
    parts_ = own_.data();
  }

  void push(const Aabb& box, std::uint32_t object) { parts_[count_++] = {box, object}; }

  const BuildJob* job_;
  std::size_t count_ = 0;
  ObjectPart* parts_;
  ScratchStack::Array<ObjectPart> own_;  // none where others own them
};

}  // namespace bspview
