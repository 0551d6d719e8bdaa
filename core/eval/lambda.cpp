#include "core/eval/lambda.h"

#include <algorithm>
#include <cmath>

namespace bspview {
namespace {

/// The value below which `share` of the sorted values lie, linear between neighbours.
double quantile(const std::vector<double>& sorted, double share) {
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

}  // namespace

Measured summarise(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  return {.median = quantile(values, 0.5),
          .spread = (quantile(values, 0.75) - quantile(values, 0.25)) / 2,
          .repeats = static_cast<int>(values.size())};
}

}  // namespace bspview
