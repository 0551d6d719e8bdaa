#include "core/eval/error/pareto.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bspview {
namespace {

bool beats(const TradeOff& a, const TradeOff& b) {
  const double margin = 2.0 * std::max(a.time_mad, b.time_mad);
  return a.time < b.time - margin && a.error <= b.error;
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const TradeOff> points) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool beaten =
        std::ranges::any_of(points, [&](const TradeOff& other) { return beats(other, points[i]); });
    if (!beaten) front.push_back(i);
  }
  std::ranges::stable_sort(
      front, [&](std::size_t a, std::size_t b) { return points[a].time < points[b].time; });
  return front;
}

std::vector<std::size_t> pareto_line(std::span<const TradeOff> points) {
  std::vector<std::size_t> line;
  for (const std::size_t i : pareto_front(points)) {
    if (line.empty() || points[i].error < points[line.back()].error) line.push_back(i);
  }
  return line;
}

std::optional<std::size_t> pareto_knee(std::span<const TradeOff> points) {
  const std::vector<std::size_t> line = pareto_line(points);
  if (line.empty()) return std::nullopt;
  const TradeOff &first = points[line.front()], &last = points[line.back()];
  const double width = std::log(last.time / first.time);
  const double height = std::log(first.error / last.error);
  if (line.size() < 3) return height > width ? line.back() : line.front();
  const auto depth = [&](std::size_t i) {
    const double right = std::log(points[i].time / first.time) / width;
    const double down = std::log(first.error / points[i].error) / height;
    return down - right;
  };
  return *std::ranges::max_element(line, {}, depth);
}

double median_of(std::span<const double> values) {
  if (values.empty()) return 0.0;
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : std::midpoint(sorted[half - 1], sorted[half]);
}

double median_absolute_deviation(std::span<const double> values) {
  const double median = median_of(values);
  std::vector<double> deviations;
  for (const double value : values) deviations.push_back(std::abs(value - median));
  return median_of(deviations);
}

}  // namespace bspview
