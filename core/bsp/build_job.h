#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/build.h"
#include "core/bsp/build_progress.h"
#include "core/bsp/cost.h"
#include "core/bsp/deferred_leaf.h"
#include "core/bsp/memory_limit.h"

namespace bspview {

/// Thrown, inside the builders only, when the stop token was requested.
struct BuildStopped {};

// Steps of a loop between two looks at the stop token: each well below a millisecond.
inline constexpr std::size_t light_steps = std::size_t{1} << 16;  ///< a few instructions each
inline constexpr std::size_t clip_steps = std::size_t{1} << 9;

// Steps of a loop that one thread takes at a time.
inline constexpr std::size_t range_size = std::size_t{1} << 14;
constexpr std::size_t range_count(std::size_t steps) {
  return (steps + range_size - 1) / range_size;
}

/// What stays the same through one build.
struct BuildJob {
  const BuildInput& input;
  Aabb box = {};              ///< of the root
  CostModel costs;            ///< C_I: the mean over the objects
  bool weighs_tests = false;  ///< objects differ in what testing them costs
  int depth = 0;              ///< of the root; not 0 where it is a node of another tree
  int max_depth = 0;
  std::size_t leaf_size = 1;
  bool clip = false;
  double min_width = 0.0;         ///< of a cell that a split makes; not 0
  double clip_margin = 0.0;       ///< of outlines
  std::size_t task_count = 0;     ///< a child with fewer objects is not worth a task of its own
  std::size_t deferred_size = 0;  ///< nodes with at most as many objects are put off; 0: none is
  std::size_t memory_limit = 0;
  MemoryMeter* meter = nullptr;       ///< null: memory is not limited
  InnerObjects* inner = nullptr;      ///< null: what inner nodes hold is not kept
  BuildProgress* progress = nullptr;  ///< null: nobody watches
  std::stop_token stop = {};

  /// What testing an object costs, in units of C_I. Only near the leaves, where it decides whether
  /// a split pays, does it count.
  float tests_of(std::uint32_t object) const {
    if (!weighs_tests) return 1.0f;
    return static_cast<float>(input.test_cost(object) / costs.intersection);
  }

  void tell(double work) const {
    if (progress && work > 0.0) progress->tell(work);
  }

  void poll() const {
    if (stop.stop_requested()) throw BuildStopped{};
  }

  /// Calls body(0) ... body(count - 1) and polls every `interval` calls.
  template <class Body>
  void for_each(std::size_t count, std::size_t interval, Body body) const {
    for (std::size_t first = 0; first < count; first += interval) {
      poll();
      const std::size_t last = std::min(count, first + interval);
      for (std::size_t i = first; i < last; ++i) body(i);
    }
  }

  /// Calls body(first, last) for ranges of range_size steps, by many threads.
  template <class Body>
  void for_each_range(std::size_t count, const Body& body) const {
    parallel_ranges(count, range_size, [&](std::size_t first, std::size_t last) {
      poll();
      body(first, last);
    });
  }
};

// Nodes count their objects with 30 bits.
inline constexpr std::size_t most_objects = (std::size_t{1} << 30) - 1;

/// The union of the boxes, each side moved outwards by 1e-5 x the largest one; throws BuildStopped.
Aabb root_box(const BuildInput& input, const std::stop_token& stop);

/// A job for the whole tree, whose root has the box `root`.
BuildJob make_job(const BuildInput& input, const BuildParams& params, const Aabb& root,
                  std::stop_token stop);

/// What it starts from; throws BuildStopped.
ObjectParts placeable_objects(const BuildJob& job);

/// Runs body(0), body(1) and body(2), at the same time when a node has many objects.
template <class Body>
void for_each_axis(std::size_t objects, const Body& body) {
  constexpr std::size_t worth_three_tasks = 4096;
  if (objects >= worth_three_tasks) return parallel_for(3, body);
  for (int axis = 0; axis < 3; ++axis) body(axis);
}

/// What rules say that know no costs.
inline constexpr double every_plane_pays = -std::numeric_limits<double>::infinity();

/// A plane, and how many objects touch each side of it (an object in the plane touches both).
struct Split {
  int axis = 0;
  float position = 0.0f;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  double tests = every_plane_pays;  ///< of a ray that crosses the cell, expected; units of C_I
};

/// The same, with the tests of both sides as leaves, which say whether it pays.
Split with_tests_of_leaves(const BuildJob& job, const Aabb& cell, Split split);

/// A split with the cell that it divides.
struct CellSplit : Split {
  CellSplit(const Split& split, const Aabb& whole)
      : Split(split), cell(whole), cells(split_cell(whole, split.axis, split.position)) {}

  /// Which side has more objects; they stay where they are while the others move out.
  bool keeps_left() const { return left >= right; }

  Aabb cell;
  Cells cells;
};

/// The planes that leave both sides of a cell at least min_width thick.
class PlaneRange {
 public:
  PlaneRange(const BuildJob& job, const Aabb& cell, int axis);
  bool holds(float position) const { return first_ <= position && position <= last_; }
  bool empty() const { return !(first_ <= last_); }
  float first() const { return first_; }
  float last() const { return last_; }

 private:
  float first_, last_;
};

}  // namespace bspview
