#include "core/eval/histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace bspview {
namespace {

constexpr std::uint64_t single_sizes = 8;  // larger leaves share a bar
constexpr double widest_bar = 48.0;        // characters

/// The bar that leaves with `size` objects belong to.
Bar bar_around(std::uint64_t size) {
  if (size <= single_sizes) return {size, size, 0};
  const std::uint64_t last = std::bit_ceil(size);
  return {last / 2 + 1, last, 0};
}

std::string label(const Bar& bar) {
  return bar.first == bar.last ? fmt::format("{}", bar.first)
                               : fmt::format("{}-{}", bar.first, bar.last);
}

}  // namespace

std::vector<Bar> depth_bars(const TreeStats& stats) {
  std::vector<Bar> bars;
  for (std::uint64_t depth = 0; depth < stats.leaves_at_depth.size(); ++depth) {
    const std::uint64_t leaves = stats.leaves_at_depth[depth];
    if (leaves != 0 || !bars.empty()) bars.push_back({depth, depth, leaves});
  }
  while (!bars.empty() && bars.back().count == 0) bars.pop_back();
  return bars;
}

std::vector<Bar> leaf_size_bars(const TreeStats& stats) {
  std::vector<Bar> bars;
  for (std::uint64_t size = 0; size < stats.leaves_with_count.size(); ++size) {
    if (bars.empty() || size > bars.back().last) bars.push_back(bar_around(size));
    bars.back().count += stats.leaves_with_count[size];
  }
  while (!bars.empty() && bars.back().count == 0) bars.pop_back();
  return bars;
}

std::string format_bars(const std::vector<Bar>& bars, const std::string& title) {
  std::uint64_t most = 1;
  std::size_t width = title.size();
  for (const Bar& bar : bars) {
    most = std::max(most, bar.count);
    width = std::max(width, label(bar).size());
  }
  std::string text = fmt::format("{:>{}}  {:>10}\n", title, width, "leaves");
  for (const Bar& bar : bars) {
    const double share = static_cast<double>(bar.count) / static_cast<double>(most);
    // A bar that is there at all is seen.
    const auto length = static_cast<std::size_t>(widest_bar * share + (bar.count > 0 ? 0.999 : 0));
    const std::string marks(std::min(length, static_cast<std::size_t>(widest_bar)), '#');
    text += fmt::format("{:>{}}  {:>10}{}{}\n", label(bar), width, bar.count,
                        marks.empty() ? "" : "  ", marks);
  }
  return text;
}

}  // namespace bspview
