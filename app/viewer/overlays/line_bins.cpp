#include "app/viewer/overlays/line_bins.h"

#include <algorithm>

namespace bspview {
namespace {

struct Range {
  int first, last;  // both included
};

/// Tiles of [lo, hi] (pixels) among `count` in a row.
Range tiles_between(float lo, float hi, int count) {
  constexpr float scale = 1.0f / TileGrid::tile_size;
  const auto limit = static_cast<float>(count - 1);
  return {static_cast<int>(std::clamp(lo * scale, 0.0f, limit)),
          static_cast<int>(std::clamp(hi * scale, 0.0f, limit))};
}

/// Calls visit(tile) for every tile that `line` may touch.
template <class Visit>
void for_tiles(const ScreenLine& line, const TileGrid& grid, const Visit& visit) {
  const int major_count = line.steep ? grid.rows() : grid.columns();
  const int minor_count = line.steep ? grid.columns() : grid.rows();
  const Range majors = tiles_between(line.first, line.last, major_count);
  for (int major = majors.first; major <= majors.last; ++major) {
    const auto start = static_cast<float>(major * TileGrid::tile_size);
    const float a = line.minor_at(std::max(line.first, start));
    const float b = line.minor_at(std::min(line.last, start + TileGrid::tile_size));
    const Range minors = tiles_between(std::min(a, b) - line.half_thickness,
                                       std::max(a, b) + line.half_thickness, minor_count);
    for (int minor = minors.first; minor <= minors.last; ++minor) {
      visit(line.steep ? major * grid.columns() + minor : minor * grid.columns() + major);
    }
  }
}

}  // namespace

LineBins::LineBins(std::span<const Line> lines, const ScreenTransform& transform,
                   const TileGrid& grid)
    : first_(grid.count() + 1, 0) {
  lines_.reserve(lines.size());
  for (const Line& line : lines) {
    if (const auto projected = project_line(transform, line)) lines_.push_back(*projected);
  }
  for (const ScreenLine& line : lines_) {
    for_tiles(line, grid, [&](int tile) { ++first_[tile]; });
  }
  std::uint32_t total = 0;
  for (std::uint32_t& entry : first_) entry = total += entry;
  order_.resize(total);
  // Filling from the back turns the ends of the tiles' ranges into their starts.
  for (std::uint32_t i = static_cast<std::uint32_t>(lines_.size()); i-- > 0;) {
    for_tiles(lines_[i], grid, [&](int tile) { order_[--first_[tile]] = i; });
  }
}

}  // namespace bspview
