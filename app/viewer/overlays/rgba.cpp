#include "app/viewer/overlays/rgba.h"

#include <algorithm>
#include <cmath>

namespace bspview {

std::uint32_t pack_color(Vec3 color, float alpha) {
  const auto byte = [](float x) {
    return static_cast<std::uint32_t>(std::lround(255.0f * std::clamp(x, 0.0f, 1.0f)));
  };
  return byte(color.r) | byte(color.g) << 8 | byte(color.b) << 16 | byte(alpha) << 24;
}

}  // namespace bspview
