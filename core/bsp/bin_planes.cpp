// After Shevtsov, Soupikov & Kapustin 2007, "Highly parallel fast kd-tree construction for
// interactive ray tracing of dynamic scenes": each axis of the cell is cut into bins, which count
// where boxes begin and where they end, and the planes between bins are priced. The best one then
// moves to the nearest side of a box where that is cheaper.

#include "core/bsp/bin_planes.h"

#include <array>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/bin_counts.h"
#include "core/math/float_error.h"

namespace bspview {
namespace {

/// Sides of boxes, by the bins of the three axes that they lie in.
class Bins {
 public:
  Bins(const BuildJob& job, const Aabb& cell) : job_(job), cell_(cell), counts_(cell) {}

  void count(std::span<const ObjectPart> parts) {
    for (std::size_t first = 0; first < parts.size(); first += light_steps) {
      job_.poll();
      counts_.count(parts.subspan(first, std::min(light_steps, parts.size() - first)));
    }
  }

  void add(const Bins& other) { counts_.add(other.counts_); }

  /// The cheapest plane between two bins of an axis.
  Split find_cheapest(int axis, std::size_t count) const {
    Split best{.axis = axis, .cost = std::numeric_limits<double>::infinity()};
    const PlaneRange range(job_, cell_, axis);
    const SplitCost cost(job_.costs, cell_, axis);
    Split split{.axis = axis, .right = static_cast<std::uint32_t>(count)};
    const double lo = component(cell_.lo, axis);
    const double step = (component(cell_.hi, axis) - lo) / BinCounts::bins;
    for (int bin = 0; bin < BinCounts::bins - 1; ++bin) {
      split.left += counts_.starts[bin][axis];
      split.right -= counts_.ends[bin][axis];
      split.position = static_cast<float>(lo + step * (bin + 1));
      split.cost = cost.divided(split.position, split.position, split.left, split.right);
      if (split.cost < best.cost && range.holds(split.position)) best = split;
    }
    return best;
  }

 private:
  const BuildJob& job_;
  const Aabb& cell_;
  BinCounts counts_;
};

/// What lies around a plane: the nearest sides of boxes, and how many touch it from either side.
class Surroundings {
 public:
  Surroundings(const BuildJob& job, const Aabb& cell, const Split& plane)
      : below(component(cell.lo, plane.axis)),
        above(component(cell.hi, plane.axis)),
        job_(job),
        plane_(plane) {}

  void count(std::span<const ObjectPart> parts) {
    const int axis = plane_.axis;
    const float position = plane_.position;
    job_.for_each(parts.size(), light_steps, [&](std::size_t i) {
      const float lo = component(parts[i].box.lo, axis), hi = component(parts[i].box.hi, axis);
      left += lo <= position;
      right += hi >= position;
      starts += lo == position;
      ends += hi == position;
      below = std::max(below, hi < position ? hi : lo < position ? lo : below);
      above = std::min(above, lo > position ? lo : hi > position ? hi : above);
    });
  }

  void add(const Surroundings& other) {
    left += other.left;
    right += other.right;
    starts += other.starts;
    ends += other.ends;
    below = std::max(below, other.below);
    above = std::min(above, other.above);
  }

  float below, above;
  std::uint32_t left = 0, right = 0;
  std::uint32_t starts = 0, ends = 0;  ///< in the plane

 private:
  const BuildJob& job_;
  const Split& plane_;
};

/// Counts a wide node in pieces, at the same time; `none` has counted nothing yet.
template <class Counts>
Counts count_all(std::span<const ObjectPart> parts, const Counts& none) {
  constexpr std::size_t worth_a_task = 2048, most_pieces = 64;
  const std::size_t pieces = std::clamp(parts.size() / worth_a_task, std::size_t{1}, most_pieces);
  const std::size_t length = (parts.size() + pieces - 1) / pieces;
  Counts whole = none;
  if (pieces == 1) {
    whole.count(parts);
    return whole;
  }
  std::vector<Counts> counts(pieces, none);
  parallel_ranges(parts.size(), length, [&](std::size_t first, std::size_t last) {
    counts[first / length].count(parts.subspan(first, last - first));
  });
  for (const Counts& piece : counts) whole.add(piece);
  return whole;
}

/// `plane`, or the nearest side of a box on either side of it where that is cheaper.
Split move_to_side(const BuildJob& job, std::span<const ObjectPart> parts, const Aabb& cell,
                   const Split& plane) {
  const auto around = count_all(parts, Surroundings(job, cell, plane));
  const float below = next_up(around.below), above = next_down(around.above);
  const PlaneRange range(job, cell, plane.axis);
  const SplitCost cost(job.costs, cell, plane.axis);
  Split best{.axis = plane.axis, .cost = std::numeric_limits<double>::infinity()};
  const auto try_plane = [&](float position, std::uint32_t left, std::uint32_t right) {
    const double here = cost.divided(position, position, left, right);
    if (range.holds(position) && here < best.cost) best = {plane.axis, position, left, right, here};
  };
  try_plane(plane.position, around.left, around.right);
  if (below < plane.position) try_plane(below, around.left - around.starts, around.right);
  if (above > plane.position) try_plane(above, around.left, around.right - around.ends);
  return best;
}

}  // namespace

Split cheapest_of_bins(const BuildJob& job, std::span<const ObjectPart> parts, const Aabb& cell) {
  // To move a plane seldom saves more: others are not worth the look at all parts.
  constexpr double worth_moving = 1.03;
  const Bins bins = count_all(parts, Bins(job, cell));
  std::array<Split, 3> planes;
  for (int axis = 0; axis < 3; ++axis) planes[axis] = bins.find_cheapest(axis, parts.size());
  const double least = std::ranges::min_element(planes, {}, &Split::cost)->cost;
  Split best{.cost = std::numeric_limits<double>::infinity()};
  if (!std::isfinite(least)) return best;
  for (const Split& plane : planes) {
    if (plane.cost > worth_moving * least) continue;
    const Split moved = move_to_side(job, parts, cell, plane);
    if (moved.cost < best.cost) best = moved;
  }
  return with_cost_of_leaves(job, cell, best);
}

}  // namespace bspview
