#pragma once

#include <string>
#include <vector>

#include "core/bsp/stats.h"

namespace bspview {

/// One bar: values from `first` to `last` occur `count` times.
struct Bar {
  std::uint64_t first = 0, last = 0, count = 0;
  bool operator==(const Bar&) const = default;
};

/// Leaves by depth, from the shallowest to the deepest.
std::vector<Bar> depth_bars(const TreeStats& stats);

/// Leaves by the number of their objects: 0 to 8 one by one, then 9-16, 17-32, ...
std::vector<Bar> leaf_size_bars(const TreeStats& stats);

/// A text chart, a line a bar, with `title` above the first column.
std::string format_bars(const std::vector<Bar>& bars, const std::string& title);

}  // namespace bspview
