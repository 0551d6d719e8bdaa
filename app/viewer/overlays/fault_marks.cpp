#include "app/viewer/overlays/fault_marks.h"

#include <algorithm>

#include "app/viewer/overlays/rgba.h"

namespace bspview {
namespace {

/// Whether the mark of a fault covers the pixel (dx, dy) from its own, -1 to 1.
bool covers(PixelFault fault, int dx, int dy) {
  if (fault == PixelFault::lost) return dx == 0 || dy == 0;
  if (fault == PixelFault::phantom) return std::abs(dx) == std::abs(dy);
  return true;
}

}  // namespace

std::uint32_t fault_color(PixelFault fault) {
  switch (fault) {
    case PixelFault::lost:
      return pack_color({1.0f, 0.2f, 0.9f});
    case PixelFault::phantom:
      return pack_color({1.0f, 0.8f, 0.1f});
    case PixelFault::self_hit:
      return pack_color({0.2f, 0.9f, 1.0f});
    default:
      return 0;
  }
}

Layer fault_marks(const PixelFaults& faults) {
  Layer layer(faults.width, faults.height);
  const auto draw = [&](int x, int y, PixelFault fault) {
    for (int v = std::max(0, y - 1); v <= std::min(faults.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(faults.width - 1, x + 1); ++u)
        if (covers(fault, u - x, v - y))
          layer.pixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(faults.width) +
                       static_cast<std::size_t>(u)] = fault_color(fault);
  };
  std::size_t i = 0;
  for (int y = 0; y < faults.height; ++y) {
    for (int x = 0; x < faults.width; ++x, ++i)
      if (fault_color(faults.pixels[i]) != 0) draw(x, y, faults.pixels[i]);
  }
  return layer;
}

}  // namespace bspview
