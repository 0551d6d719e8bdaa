// After Wald & Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in
// O(N log N)", section 4: every plane at which an object part begins or ends is tried, in one
// sweep over the presorted events of each axis.

#include "core/bsp/event_list.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

/// The cheapest plane on one axis of a cell; its cost is infinite when there is no room for one.
Split cheapest_on_axis(const BuildJob& job, const EventList& list, const Aabb& cell, int axis) {
  Split best{.axis = axis, .cost = std::numeric_limits<double>::infinity()};
  const PlaneRange range(job, cell, axis);
  if (range.empty()) return best;

  const std::span<const Event> events = list.events(axis);
  const std::size_t inside = count_before(events, range.first());
  const std::size_t behind = count_up_to(events, range.last());
  const SplitCost cost(job.costs, cell, axis);
  std::uint32_t left = 0;  // objects that touch the cell on this side of the plane
  auto right = static_cast<std::uint32_t>(list.count());
  const auto try_plane = [&](float position) {
    const double here = cost(position, left, right);
    if (here < best.cost) best = {axis, position, left, right, here};
  };

  job.for_each(inside, light_steps, [&](std::size_t i) {
    left += events[i].is_start();
    right -= events[i].is_end();
  });
  try_plane(range.first());
  job.for_each(behind - inside, light_steps, [&](std::size_t i) {
    const Event event = events[inside + i];
    right -= event.is_end();
    try_plane(event.position());
    left += event.is_start();
  });
  try_plane(range.last());
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
