#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>

#include "core/base/watch.h"

namespace bspview {

/// Work of a node in shares of that of the whole tree: its own, and that of its children and all
/// below them.
struct WorkShares {
  double own, left, right;
};

/// Tells whoever watches a build how far it is. Every node has a share of the work, of which it
/// keeps a part and deals the rest out to its children: what is told only grows, but for the start
/// of another try, and adds up to 1. Nodes of few objects tell all of theirs at once, so that
/// telling takes no time.
class BuildProgress {
 public:
  BuildProgress(const Watch& watch, std::size_t objects)
      : watch_(watch), fewest_(std::max(objects / most_parts, fewest_objects)) {}

  /// Whether a node with so many objects tells of its children one by one.
  bool tells_apart(std::size_t objects) const { return objects > fewest_; }

  /// Safe to call from several threads.
  void tell(double more) {
    told_.fetch_add(more, std::memory_order_relaxed);
    watch_.advance(more);
  }
  /// Takes back all that was told.
  void begin_again() { watch_.advance(-told_.exchange(0.0)); }
  /// Of what was never told: work that did not have to be done.
  void tell_rest() const { watch_.advance(std::max(0.0, 1.0 - told_)); }

  /// Of a node that is split into children with `left` and `right` objects, whose share is `work`.
  static WorkShares deal(double work, std::size_t left, std::size_t right) {
    const double own = static_cast<double>(left + right);
    const double below_left = work_below(left), below_right = work_below(right);
    const double unit = work / (own + below_left + below_right);
    return {own * unit, below_left * unit, below_right * unit};
  }
  /// Of the root: what is to be done before it is split counts as so many levels of nodes.
  static double first_share(std::size_t objects) {
    return objects == 0 ? 0.0 : levels_before / (levels_before + levels(objects));
  }

 private:
  static constexpr std::size_t most_parts = 512, fewest_objects = 256;
  // In units of what a wide node takes an object. As measured with `sah`.
  static constexpr double levels_before = 3.0, last_levels = 4.0;

  static double levels(std::size_t objects) {
    constexpr std::size_t few = 32;
    return last_levels + static_cast<double>(std::bit_width(objects / few));
  }
  static double work_below(std::size_t objects) {
    return static_cast<double>(objects) * levels(objects);
  }

  const Watch& watch_;
  const std::size_t fewest_;
  std::atomic<double> told_ = 0.0;
};

}  // namespace bspview
