// After Shevtsov, Soupikov & Kapustin 2007, "Highly parallel fast kd-tree construction for
// interactive ray tracing of dynamic scenes": each axis of the cell is cut into bins, which count
// where boxes begin and where they end, and the planes between bins are priced. The best one then
// moves to the side of a box in the bins around it where that is cheaper.

#include "core/bsp/bin_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/bin_counts.h"
#include "core/bsp/plane_surroundings.h"

namespace bspview {
namespace {

/// Sides of boxes, by the bins of the three axes that they lie in.
class Bins {
 public:
  Bins(const BuildJob& job, const Aabb& cell, std::size_t objects)
      : job_(job), cell_(cell), counts_(cell, objects) {}

  void count(std::span<const ObjectPart> parts) {
    for (std::size_t first = 0; first < parts.size(); first += light_steps) {
      job_.poll();
      counts_.count(parts.subspan(first, std::min(light_steps, parts.size() - first)));
    }
  }

  void add(const Bins& other) { counts_.add(other.counts_); }

  float width(int axis) const {
    return (component(cell_.hi, axis) - component(cell_.lo, axis)) /
           static_cast<float>(counts_.bins);
  }

  /// The cheapest plane between two bins of an axis.
  Split find_cheapest(int axis, std::size_t count) const {
    Split best{.axis = axis, .tests = std::numeric_limits<double>::infinity()};
    const PlaneRange range(job_, cell_, axis);
    const SplitTests tests(job_.costs, cell_, axis);
    Split split{.axis = axis, .right = static_cast<std::uint32_t>(count)};
    const double lo = component(cell_.lo, axis);
    const double step = (component(cell_.hi, axis) - lo) / static_cast<double>(counts_.bins);
    for (std::size_t bin = 0; bin + 1 < counts_.bins; ++bin) {
      split.left += counts_.starts[bin][axis];
      split.right -= counts_.ends[bin][axis];
      split.position = static_cast<float>(lo + step * static_cast<double>(bin + 1));
      split.tests = tests.divided(split.position, split.position, split.left, split.right);
      if (split.tests < best.tests && range.holds(split.position)) best = split;
    }
    return best;
  }

 private:
  const BuildJob& job_;
  const Aabb& cell_;
  BinCounts counts_;
};

/// Counts a wide node in pieces, at the same time; `whole` has counted nothing yet.
template <class Counts>
void count_all(std::span<const ObjectPart> parts, Counts& whole) {
  constexpr std::size_t worth_a_task = 2048, most_pieces = 64;
  const std::size_t pieces = std::clamp(parts.size() / worth_a_task, std::size_t{1}, most_pieces);
  const std::size_t length = (parts.size() + pieces - 1) / pieces;
  if (pieces == 1) return whole.count(parts);
  std::vector<Counts> counts(pieces, whole);
  parallel_ranges(parts.size(), length, [&](std::size_t first, std::size_t last) {
    counts[first / length].count(parts.subspan(first, last - first));
  });
  for (const Counts& piece : counts) whole.add(piece);
}

}  // namespace

Split cheapest_of_bins(const BuildJob& job, std::span<const ObjectPart> parts, const Aabb& cell) {
  // To move a plane seldom saves more: others are not worth the look at all parts.
  constexpr double worth_moving = 1.03;
  Bins bins(job, cell, parts.size());
  count_all(parts, bins);
  std::array<Split, 3> planes;
  for (int axis = 0; axis < 3; ++axis) planes[axis] = bins.find_cheapest(axis, parts.size());
  const double least = std::ranges::min_element(planes, {}, &Split::tests)->tests;
  Split best{.tests = std::numeric_limits<double>::infinity()};
  if (!std::isfinite(least)) return best;
  for (const Split& plane : planes) {
    if (plane.tests > worth_moving * least) continue;
    PlaneSurroundings around(job, cell, plane, bins.width(plane.axis));
    count_all(parts, around);
    const Split moved = around.cheapest();
    if (moved.tests < best.tests) best = moved;
  }
  return with_tests_of_leaves(job, cell, best);
}

}  // namespace bspview
