#include "core/bsp/event_list.h"

#include <algorithm>

#include "core/bsp/clip_part.h"
#include "core/bsp/event_sort.h"

namespace bspview {
namespace {

constexpr std::uint32_t nowhere = 0xffffffffu;

/// Which side of the plane a part of a node touches.
enum Side : std::uint8_t { left_side = 1, right_side = 2, both_sides = 3 };

void write_events(const Aabb& box, int axis, std::uint32_t part, Event* events) {
  events[0] = Event::make_start(box.lo[axis], part);
  events[1] = Event::make_end(box.hi[axis], part);
}

}  // namespace

/// A child while it is filled. Parts that are clipped lose their old events and get fresh ones.
class EventList::Child {
 public:
  Child(EventList& list, std::size_t parent_count, std::size_t straddling, ScratchStack& scratch)
      : list_(list),
        target_(scratch, parent_count),
        fresh_(scratch, straddling),
        fresh_events_(scratch, 12 * straddling) {}

  std::uint32_t count() const { return count_; }

  /// The part number `part` of the parent does not come here.
  void skip(std::size_t part) { target_[part] = nowhere; }

  void add(std::size_t part, std::uint32_t object) {
    target_[part] = count_;
    list_.objects_[count_++] = object;
  }

  /// The part has become `box`.
  void add_clipped(std::size_t part, std::uint32_t object, const Aabb& box) {
    target_[part] = nowhere;
    if (box.empty()) return;
    fresh_[fresh_count_++] = {box, count_};
    list_.objects_[count_++] = object;
  }

  /// Writes an event of the parent to `to`, and tells whether it belongs here.
  bool put(Event event, Event* to) const {
    const std::uint32_t target = target_[event.part()];
    *to = event.with_part(target);
    return target != nowhere;
  }

  /// Completes one axis with the events of the clipped parts.
  void merge_fresh(int axis) const {
    const std::span<Event> fresh(fresh_events_.data() + 4 * axis * fresh_count_, 2 * fresh_count_);
    list_.job_->for_each(fresh_count_, light_steps, [&](std::size_t i) {
      write_events(fresh_[i].box, axis, fresh_[i].object, &fresh[2 * i]);
    });
    const std::span<Event> sorted(fresh.data() + fresh.size(), fresh.size());
    sort_events(*list_.job_, fresh, sorted.data());
    merge_events(*list_.job_, {list_.first_event(axis), 2 * (count_ - fresh_count_)}, sorted);
  }

  Event* first_event(int axis) const { return list_.first_event(axis); }

 private:
  EventList& list_;
  ScratchStack::Array<std::uint32_t> target_;  // index of the parent's part in the child
  ScratchStack::Array<ObjectPart> fresh_;      // object: index in the child
  ScratchStack::Array<Event> fresh_events_;
  std::size_t fresh_count_ = 0;
  std::uint32_t count_ = 0;
};

EventList::EventList(const BuildJob& job, std::size_t capacity, ScratchStack& scratch)
    : job_(&job),
      stride_(2 * capacity + 1),  // a list may be written to one event behind its end
      events_(scratch, 3 * stride_),
      objects_(scratch, capacity) {}

EventList::EventList(const BuildJob& job, std::span<const ObjectPart> parts, ScratchStack& scratch)
    : EventList(job, parts.size(), scratch) {
  count_ = parts.size();
  const ScratchStack::Array<Event> unsorted(scratch, 3 * stride_);
  for_each_axis(count_, [&](int axis) {
    Event* const events = unsorted.data() + axis * stride_;
    job.for_each_range(count_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        write_events(parts[i].box, axis, static_cast<std::uint32_t>(i), events + 2 * i);
      }
    });
    sort_events(job, {events, 2 * count_}, first_event(axis));
  });
  job.for_each(count_, light_steps, [&](std::size_t i) { objects_[i] = parts[i].object; });
}

void EventList::write_objects(std::uint32_t* to) const {
  std::copy_n(objects_.data(), count_, to);
}

FewParts EventList::few_parts(ScratchStack& scratch) const {
  std::array<Aabb, FewParts::most> boxes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Event event : events(axis)) {
      Aabb& box = boxes[event.part()];
      (event.is_start() ? box.lo : box.hi)[axis] = event.bound();
    }
  }
  FewParts few(*job_, scratch);
  for (std::size_t i = 0; i < count_; ++i) few.push(boxes[i], objects_[i]);
  return few;
}

void EventList::find_sides(const Split& split, std::uint8_t* sides) const {
  const std::span<const Event> all = events(split.axis);
  const std::size_t first = count_before(all, split.position);
  const std::size_t last = count_up_to(all, split.position);
  std::fill_n(sides, count_, std::uint8_t{0});
  job_->for_each(first, light_steps,
                 [&](std::size_t i) { sides[all[i].part()] |= all[i].is_start() * left_side; });
  job_->for_each(all.size() - last, light_steps, [&](std::size_t i) {
    sides[all[last + i].part()] |= all[last + i].is_end() * right_side;
  });
}

void EventList::deal_objects(const CellSplit& split, const std::uint8_t* sides,
                             const Children& to) const {
  job_->for_each(count_, clip_steps, [&](std::size_t i) {
    const std::uint32_t object = objects_[i];  // before others take its place
    if (job_->clip && sides[i] == both_sides) {
      const SideBoxes boxes = clip_sides(*job_, object, split);
      to.left.add_clipped(i, object, boxes.left);
      to.right.add_clipped(i, object, boxes.right);
      return;
    }
    sides[i] & left_side ? to.left.add(i, object) : to.left.skip(i);
    sides[i] & right_side ? to.right.add(i, object) : to.right.skip(i);
  });
}

void EventList::deal_events(int axis, const Children& to) const {
  const std::span<const Event> all = events(axis);
  Event* to_left = to.left.first_event(axis);
  Event* to_right = to.right.first_event(axis);
  job_->for_each(all.size(), light_steps, [&](std::size_t i) {
    const Event event = all[i];
    to_left += to.left.put(event, to_left);
    to_right += to.right.put(event, to_right);
  });
  to.left.merge_fresh(axis);
  to.right.merge_fresh(axis);
}

EventList EventList::split(const CellSplit& split, ScratchStack& scratch) {
  EventList other(*job_, std::min(split.left, split.right), scratch);
  EventList& left_list = split.keeps_left() ? *this : other;
  EventList& right_list = split.keeps_left() ? other : *this;
  const std::size_t straddling = split.left + split.right - count_;
  Child left(left_list, count_, straddling, scratch);
  Child right(right_list, count_, straddling, scratch);
  const ScratchStack::Array<std::uint8_t> sides(scratch, count_);

  find_sides(split, sides.data());
  deal_objects(split, sides.data(), {left, right});
  for_each_axis(count_, [&](int axis) { deal_events(axis, {left, right}); });
  left_list.count_ = left.count();
  right_list.count_ = right.count();
  return other;
}

}  // namespace bspview
