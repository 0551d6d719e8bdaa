#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace bspview {

/// What something costs and how wrong it is; both are better when smaller.
struct TradeOff {
  double time = 0.0;
  double time_mad = 0.0;  ///< median absolute deviation of the repeats behind `time`
  double error = 0.0;     ///< > 0; where nothing was found, the upper bound of that
};

/// Indices of the points on the Pareto front, from the fastest to the slowest. A point is off it
/// when another one is faster by more than twice the larger of their median absolute deviations and
/// has no larger error. Of points with the same error only the fastest, and those as fast as far as
/// the deviations tell, are on it.
std::vector<std::size_t> pareto_front(std::span<const TradeOff> points);

/// Lower border of the front: its points without those that a faster or equally fast one matches.
/// Errors fall along it; it is what a line can be drawn through.
std::vector<std::size_t> pareto_line(std::span<const TradeOff> points);

/// The knee of the front: the point of its line farthest below the straight line between the ends,
/// both axes in logarithms and as long as the front. With less than three points: the last when it
/// divides the error by more than it multiplies the time, else the first. Nothing for no points.
std::optional<std::size_t> pareto_knee(std::span<const TradeOff> points);

/// Median of the absolute deviations from the median.
double median_absolute_deviation(std::span<const double> values);
double median_of(std::span<const double> values);

}  // namespace bspview
