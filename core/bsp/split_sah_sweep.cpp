// After Wald & Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in
// O(N log N)", section 4: every plane at which an object part begins or ends is tried, in one
// sweep over the presorted events of each axis.

#include "core/bsp/event_list.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

/// A plane that moves along one axis of a cell and keeps the cheapest position.
class Sweep {
 public:
  Sweep(const SplitCost& cost, Split& best, std::size_t count)
      : cost_(cost), best_(best), right_(static_cast<std::uint32_t>(count)) {}

  void pass(Event event) {
    right_ -= !event.is_start();
    left_ += event.is_start();
  }

  void try_and_pass(int axis, Event event) {
    right_ -= !event.is_start();
    try_plane(axis, event.position());
    left_ += event.is_start();
  }

  void try_plane(int axis, float position) {
    const double cost = cost_(position, left_, right_);
    if (cost < best_.cost) best_ = {axis, position, left_, right_, cost};
  }

 private:
  const SplitCost& cost_;
  Split& best_;
  std::uint32_t left_ = 0;
  std::uint32_t right_;
};

/// The cheapest plane on one axis of a cell; its cost is infinite when there is no room for one.
Split cheapest_on_axis(const BuildJob& job, const EventList& list, const Aabb& cell, int axis) {
  Split best{.axis = axis, .cost = std::numeric_limits<double>::infinity()};
  const PlaneRange range(job, cell, axis);
  if (range.empty()) return best;

  const SplitCost cost(job.costs, cell, axis);
  const std::span<const Event> events = list.events(axis);
  Sweep sweep(cost, best, list.count());
  const auto position = [](Event event) { return event.position(); };
  const auto inside = std::ranges::lower_bound(events, range.first(), {}, position);
  const auto behind = std::ranges::upper_bound(events, range.last(), {}, position);
  const auto steps = [&](auto first, auto last, auto body) {
    job.for_each(last - first, light_steps, [&](std::size_t i) { body(first[i]); });
  };
  steps(events.begin(), inside, [&](Event event) { sweep.pass(event); });
  sweep.try_plane(axis, range.first());
  steps(inside, behind, [&](Event event) { sweep.try_and_pass(axis, event); });
  sweep.try_plane(axis, range.last());
  return best;
}

class SweptObjects {
 public:
  SweptObjects(const BuildJob& job, EventList events) : job_(&job), events_(std::move(events)) {}

  std::size_t count() const { return events_.count(); }
  void append_objects(std::vector<std::uint32_t>& objects) const {
    events_.append_objects(objects);
  }

  std::optional<Split> find_split(const Place& place) const {
    std::array<Split, 3> splits;
    for_each_axis(count(), [&](int axis) {
      splits[axis] = cheapest_on_axis(*job_, events_, place.cell, axis);
    });
    const Split& best = *std::ranges::min_element(splits, {}, &Split::cost);
    return std::isfinite(best.cost) ? std::optional(best) : std::nullopt;
  }

  SweptObjects split(const Split& split, const Cells& cells, ScratchStack& scratch) {
    return SweptObjects(*job_, events_.split(split, cells, scratch));
  }

 private:
  const BuildJob* job_;
  EventList events_;
};

}  // namespace

void grow_sah(const BuildJob& job, std::vector<ObjectPart> parts, Branch& branch) {
  SweptObjects objects(job, EventList(job, parts, branch.scratch));
  parts = {};
  Recursion<SweptObjects>(job).grow_root(objects, branch);
}

}  // namespace bspview
