// After Wald & Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in
// O(N log N)", section 4: one sweep over the presorted events of each axis. Where the cheapest
// plane cannot be, events are only counted.

#include "core/bsp/event_sweep.h"

#include <array>

namespace bspview {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Objects that touch the cell on either side of a plane.
struct Sides {
  std::uint32_t left, right;
};

/// Events of an axis in a row.
struct Stretch {
  std::span<const Event> events;
  Sides before, behind;  ///< of planes right before and right behind all of them
};

class AxisSweep {
 public:
  AxisSweep(const BuildJob& job, const Aabb& cell, int axis)
      : job_(job), tests_(job.costs, cell, axis), range_(job, cell, axis) {
    best_.axis = axis;
    best_.tests = infinity;
  }

  /// Cuts the events into stretches; the result is the least of the planes between them.
  double prepare(const EventList& list) {
    if (range_.empty()) return infinity;
    const std::span<const Event> events = list.events(best_.axis);
    const std::size_t inside = count_before(events, range_.first());
    const std::size_t behind = count_up_to(events, range_.last());
    const auto count = static_cast<std::uint32_t>(list.count());
    first_ = last_ = pass({0, count}, events.first(inside));
    return cut_up(events.subspan(inside, behind - inside));
  }

  /// The cheapest plane, if it takes at most `least` tests.
  Split find_cheapest(double least) {
    if (range_.empty()) return best_;
    try_plane(range_.first(), first_);
    for (const Stretch& stretch : std::span(stretches_).first(stretch_count_)) {
      if (!(least_tests(stretch) > std::min(least, best_.tests))) sweep(stretch);
    }
    try_plane(range_.last(), last_);
    return best_;
  }

 private:
  static constexpr std::size_t most_stretches = 64;
  static constexpr std::size_t shortest = 32;

  Sides pass(Sides sides, std::span<const Event> events) const {
    std::uint32_t starts = 0;
    job_.for_each(events.size(), light_steps,
                  [&](std::size_t i) { starts += events[i].is_start(); });
    const auto ends = static_cast<std::uint32_t>(events.size()) - starts;
    return {sides.left + starts, sides.right - ends};
  }

  double cut_up(std::span<const Event> events) {
    const std::size_t length =
        std::max(shortest, (events.size() + most_stretches - 1) / most_stretches);
    double least = infinity;
    for (std::size_t first = 0; first < events.size(); first += length) {
      const auto some = events.subspan(first, std::min(length, events.size() - first));
      const Event event = some.front();
      const double here = event.position();
      least = std::min(least, tests_.divided(here, here, last_.left, last_.right - event.is_end()));
      stretches_[stretch_count_++] = {some, last_, pass(last_, some)};
      last_ = stretches_[stretch_count_ - 1].behind;
    }
    return least;
  }

  double least_tests(const Stretch& stretch) const {
    return tests_.divided(stretch.events.front().position(), stretch.events.back().position(),
                          stretch.before.left, stretch.behind.right);
  }

  void sweep(const Stretch& stretch) {
    Sides sides = stretch.before;
    job_.for_each(stretch.events.size(), light_steps, [&](std::size_t i) {
      const Event event = stretch.events[i];
      sides.right -= event.is_end();
      try_plane(event.position(), sides);
      sides.left += event.is_start();
    });
  }

  void try_plane(float position, Sides sides) {
    const double tests = tests_.divided(position, position, sides.left, sides.right);
    if (tests < best_.tests) best_ = {best_.axis, position, sides.left, sides.right, tests};
  }

  const BuildJob& job_;
  const SplitTests tests_;
  const PlaneRange range_;
  Split best_;
  Sides first_{}, last_{};  // of the first and the last plane in range
  std::array<Stretch, most_stretches> stretches_;
  std::size_t stretch_count_ = 0;
};

}  // namespace

Split cheapest_of_events(const BuildJob& job, const EventList& list, const Aabb& cell) {
  std::array<AxisSweep, 3> sweeps{AxisSweep(job, cell, 0), AxisSweep(job, cell, 1),
                                  AxisSweep(job, cell, 2)};
  std::array<double, 3> least;
  for_each_axis(list.count(), [&](int axis) { least[axis] = sweeps[axis].prepare(list); });
  const double least_of_all = *std::ranges::min_element(least);
  std::array<Split, 3> splits;
  for_each_axis(list.count(),
                [&](int axis) { splits[axis] = sweeps[axis].find_cheapest(least_of_all); });
  return with_tests_of_leaves(job, cell, *std::ranges::min_element(splits, {}, &Split::tests));
}

}  // namespace bspview
