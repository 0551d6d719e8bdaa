#pragma once

#include <vector>

#include "core/bsp/few_parts.h"

namespace bspview {

/// The objects of a node by their boxes, whose planes are priced by counting box sides in bins.
class BinnedParts {
 public:
  BinnedParts(const BuildJob& job, std::span<const ObjectPart> parts, ScratchStack& scratch);

  std::size_t count() const { return count_; }
  void append_objects(std::vector<std::uint32_t>& objects) const;
  std::optional<Split> find_split(const Place& place) const;
  FewParts few_parts(ScratchStack& scratch) const;
  BinnedParts split(const CellSplit& split, ScratchStack& scratch);
  void release() { parts_.release(); }
  std::span<const ObjectPart> parts() const { return {parts_.data(), count_}; }

 private:
  BinnedParts(const BuildJob& job, std::size_t capacity, ScratchStack& scratch)
      : job_(&job), parts_(scratch, capacity) {}

  void push(const Aabb& box, std::uint32_t object) { parts_[count_++] = {box, object}; }

  const BuildJob* job_;
  std::size_t count_ = 0;
  ScratchStack::Array<ObjectPart> parts_;
};

}  // namespace bspview
