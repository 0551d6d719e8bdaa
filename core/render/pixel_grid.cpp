#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

int tiles_along(int pixels) {
  return (pixels + tile_size - 1) / tile_size;
}

}  // namespace

int tile_count(int width, int height) {
  return tiles_along(width) * tiles_along(height);
}

void for_each_tile(int width, int height, std::stop_token stop,
                   const std::function<void(const Tile&, int)>& body) {
  const int columns = tiles_along(width);
  parallel_for(tile_count(width, height), [&](int index) {
    if (stop.stop_requested()) return;
    const int x = (index % columns) * tile_size, y = (index / columns) * tile_size;
    body({x, y, std::min(x + tile_size, width), std::min(y + tile_size, height)}, index);
  });
}

}  // namespace bspview
