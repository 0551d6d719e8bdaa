#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/bsp/tree.h"

namespace bspview {

/// Constants of the surface-area heuristic: the expected cost of a ray that crosses a node is
/// `intersection` an object in a leaf, and `traversal` plus the children's shares in an inner node.
struct CostModel {
  double traversal = 0.0;
  double intersection = 0.0;
  double empty_factor = 1.0;  ///< of the tests behind a plane with one empty side
  bool counts_all = false;    ///< sides that are divided further count as leaves do

  double leaf(std::size_t objects) const { return intersection * static_cast<double>(objects); }

  /// What a plane has to save to pay: `traversal` in tests.
  double least_saving() const {
    if (intersection > 0.0) return traversal / intersection;
    return traversal > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
  }
};

/// With `cost_intersection` where the parameters have none. Nonsense (negative or not a number)
/// counts as 0.
CostModel cost_model(const BuildParams& params, float cost_intersection);

/// What `objects` that a plane leaves on one side are expected to cost, in tests. A leaf of many
/// would cost as many, but they are divided further: to count them all makes planes that put a
/// few objects into large cells, only to cut a little off what holds the most. That many objects
/// cost their number to the power of 0.7 makes trees of the least expected cost on the standard
/// scenes (0.6 to 0.9 were tried; between powers of two it is a line).
inline double tests_below(std::uint32_t objects) {
  struct Line {
    double at_0 = 0.0, slope = 1.0;
  };
  static constexpr auto lines = [] {
    constexpr std::uint32_t first_power = 6;  // up to 64 objects, all count
    std::array<Line, 32> from_power;
    double number = 1u << first_power, tests = number;
    for (std::uint32_t power = first_power; power < from_power.size(); ++power) {
      const double twice = 1.6245047927124710 * tests;  // 2^0.7
      from_power[power] = {2.0 * tests - twice, (twice - tests) / number};
      number *= 2.0;
      tests = twice;
    }
    return from_power;
  }();
  const Line& line = lines[static_cast<std::uint32_t>(std::bit_width(objects | 1u)) - 1];
  return line.at_0 + line.slope * objects;
}

/// Objects that a ray that crosses a cell is expected to test where a plane across one axis divides
/// it and both sides become leaves, less the bonus where one side is empty. C_T and C_I do not
/// matter: the same plane is the best for all.
/// After MacDonald & Booth 1990, "Heuristics for ray tracing using space subdivision".
struct SplitTests {
  SplitTests(const CostModel& model, const Aabb& cell, int axis);

  /// `left` and `right` objects touch the two sides of the plane at `position`.
  double operator()(double position, std::uint32_t left, std::uint32_t right) const {
    return expected(position, position, left, right);
  }

  /// The same when they are divided further. No plane from `first` to `last` takes fewer, rounding
  /// included, if at least `left` and `right` objects touch the sides of all of them.
  double divided(double first, double last, std::uint32_t left, std::uint32_t right) const {
    if (counts_all) return expected(first, last, left, right);
    return expected(first, last, tests_below(left), tests_below(right));
  }

  double expected(double first, double last, double left, double right) const {
    const double tests = left * (caps + rim * (first - lo)) + right * (caps + rim * (hi - last));
    return left == 0.0 || right == 0.0 ? tests * empty_factor : tests;
  }

  double lo, hi;     ///< of the cell
  double caps, rim;  ///< of the two faces parallel to the plane; of the others, a unit of length
  double empty_factor;
  bool counts_all;
};

/// Probability that a ray that crosses `cell` also crosses `part` of it: the ratio of their areas,
/// or of their lengths where the cell is a line; 1 where it is a point or empty.
double crossing_probability(const Aabb& part, const Aabb& cell);

}  // namespace bspview
