#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/viewer/overlays/screen_line.h"

namespace bspview {

/// Square tiles over a picture, row-major from the upper left one.
struct TileGrid {
  static constexpr int tile_size = 64;  ///< pixels; layer and distance of a tile fit the L1 cache

  int width = 0, height = 0;  ///< of the picture

  int columns() const { return (width + tile_size - 1) / tile_size; }
  int rows() const { return (height + tile_size - 1) / tile_size; }
  int count() const { return columns() * rows(); }
};

/// Projected lines, sorted by the tiles they may touch; within a tile in their given order.
class LineBins {
 public:
  LineBins() = default;
  LineBins(std::span<const Line> lines, const ScreenTransform& transform, const TileGrid& grid);

  std::span<const std::uint32_t> in_tile(int tile) const {
    return std::span(order_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
  }
  const ScreenLine& line(std::uint32_t i) const { return lines_[i]; }

 private:
  std::vector<ScreenLine> lines_;
  std::vector<std::uint32_t> first_;  // per tile: index into order_
  std::vector<std::uint32_t> order_;  // indices into lines_
};

}  // namespace bspview
