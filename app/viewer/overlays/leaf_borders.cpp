#include "app/viewer/overlays/leaf_borders.h"

#include "app/viewer/overlays/rgba.h"
#include "core/base/check.h"

namespace bspview {

Layer leaf_borders(std::span<const std::uint32_t> leaf, int width, int height,
                   std::uint32_t color) {
  Layer layer(width, height);
  BSPVIEW_CHECK(leaf.size() == layer.pixels.size());
  const std::uint32_t ink = premultiply(color);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const bool right = x + 1 < width && leaf[i + 1] != leaf[i];
      const bool below = y + 1 < height && leaf[i + width] != leaf[i];
      if (right || below) layer.pixels[i] = ink;
    }
  }
  return layer;
}

}  // namespace bspview
