#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "app/viewer/overlays/layer.h"
#include "app/viewer/overlays/line_bins.h"
#include "app/viewer/overlays/line_raster.h"

namespace bspview {

/// One tile of a layer while lines are drawn into it: everything it touches stays in the cache.
class TileCanvas {
 public:
  static constexpr int size = TileGrid::tile_size;
  static constexpr int border = 16;  ///< takes what lines along the sides leave beside the tile
  static constexpr int stride = size + 2 * border;
  static constexpr std::size_t area = std::size_t{stride} * stride;

  /// `pixel_size` as in ScreenTransform.
  TileCanvas(const LineView& view, const TileGrid& grid, int tile, float pixel_size);

  void draw(const ScreenLine& line);
  /// Writes the tile to its place; premultiplies.
  void store(Layer& layer) const;

 private:
  template <bool steep>
  void draw_along(const ScreenLine& line);
  void load_distances(const LineView& view);

  int column_, row_;    // of the tile's upper left pixel
  float visible_from_;  // least distance / depth at which a line is in front of the surface
  float hidden_alpha_;
  std::array<std::uint32_t, area> pixels_{};  // as in Line, not premultiplied
  std::array<float, area> farthest_;          // distance in a pixel and its neighbours
};

}  // namespace bspview
