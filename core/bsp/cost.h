#pragma once

#include <cstdint>

#include "core/bsp/tree.h"

namespace bspview {

/// Constants of the surface-area heuristic: the expected cost of a ray that crosses a node is
/// `intersection` an object in a leaf, and `traversal` plus the children's shares in an inner node.
struct CostModel {
  double traversal = 0.0;
  double intersection = 0.0;
  double empty_factor = 1.0;  ///< of the cost of a split with one empty side

  double leaf(std::size_t objects) const { return intersection * static_cast<double>(objects); }
};

/// With `cost_intersection` where the parameters have none. Nonsense (negative or not a number)
/// counts as 0.
CostModel cost_model(const BuildParams& params, float cost_intersection);

/// Cost of splitting one cell on one axis, when both children become leaves.
/// After MacDonald & Booth 1990, "Heuristics for ray tracing using space subdivision".
struct SplitCost {
  SplitCost(const CostModel& model, const Aabb& cell, int axis);

  /// `left` and `right` objects touch the two sides of the plane at `position`.
  double operator()(double position, std::uint32_t left, std::uint32_t right) const {
    return at_least(position, position, left, right);
  }

  /// No plane from `first` to `last` costs less, rounding included, if at least `left` and `right`
  /// objects touch the sides of all of them.
  double at_least(double first, double last, std::uint32_t left, std::uint32_t right) const {
    const double tests = left * (caps + rim * (first - lo)) + right * (caps + rim * (hi - last));
    const double cost = traversal + tests;
    return left == 0 || right == 0 ? cost * empty_factor : cost;
  }

  double lo, hi;     ///< of the cell
  double caps, rim;  ///< of the two faces parallel to the plane; of the others, a unit of length
  double traversal, empty_factor;
};

/// Probability that a ray that crosses `cell` also crosses `part` of it: the ratio of their areas,
/// or of their lengths where the cell is a line; 1 where it is a point or empty.
double crossing_probability(const Aabb& part, const Aabb& cell);

}  // namespace bspview
