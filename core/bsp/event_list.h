#pragma once

#include <span>
#include <vector>

#include "core/bsp/build_job.h"
#include "core/bsp/event.h"
#include "core/bsp/few_parts.h"
#include "core/bsp/scratch_stack.h"

namespace bspview {

/// The objects of a node as three lists of events, one an axis, sorted once for the whole tree:
/// dividing them keeps their order, and only clipped parts make new ones.
class EventList {
 public:
  /// Sorts the events of `parts`, which come in ascending order of their objects.
  EventList(const BuildJob& job, std::span<const ObjectPart> parts, ScratchStack& scratch);

  std::size_t count() const { return count_; }
  std::span<const Event> events(int axis) const { return {first_event(axis), 2 * count_}; }
  void write_objects(std::uint32_t* to) const;

  /// The parts of a node that holds few.
  FewParts few_parts(ScratchStack& scratch) const;

  /// Keeps what touches one cell, in place, and returns what touches the other.
  EventList split(const CellSplit& split, ScratchStack& scratch);
  void release() {
    objects_.release();
    events_.release();
  }

 private:
  class Child;
  struct Children {
    Child &left, &right;
  };

  EventList(const BuildJob& job, std::size_t capacity, ScratchStack& scratch);

  Event* first_event(int axis) const { return events_.data() + axis * stride_; }
  void find_sides(const Split& split, std::uint8_t* sides) const;
  void deal_objects(const CellSplit& split, const std::uint8_t* sides, const Children& to) const;
  void deal_events(int axis, const Children& to) const;

  const BuildJob* job_;
  std::size_t count_ = 0;
  std::size_t stride_;  // from one axis to the next
  ScratchStack::Array<Event> events_;
  ScratchStack::Array<std::uint32_t> objects_;
};

}  // namespace bspview
