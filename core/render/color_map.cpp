// Viridis and magma: van der Walt & Smith 2015, as published with matplotlib. Cividis: Nunez,
// Anderton & Renslow 2018, "Optimizing colormaps with consideration for color vision deficiency".
// Every 15th of their 256 colours; linear between them, which is off by 11/255 at most.
#include "core/render/color_map.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <glm/common.hpp>

namespace bspview {
namespace {

using ControlPoints = std::array<std::uint32_t, 18>;  // 0xRRGGBB, evenly spaced over [0, 1]

constexpr ControlPoints viridis{0x440154, 0x481769, 0x472a7a, 0x433d84, 0x3d4e8a, 0x355e8d,
                                0x2e6d8e, 0x297b8e, 0x23898e, 0x1f978b, 0x21a585, 0x2eb37c,
                                0x46c06f, 0x65cb5e, 0x89d548, 0xb0dd2f, 0xd8e219, 0xfde725};
constexpr ControlPoints cividis{0x00224e, 0x002d68, 0x163770, 0x2e416d, 0x3f4c6c, 0x4e566c,
                                0x5c616e, 0x696b71, 0x767676, 0x838179, 0x928c78, 0xa09875,
                                0xafa471, 0xbfb06b, 0xcfbd62, 0xdfca57, 0xf0d846, 0xfee838};
constexpr ControlPoints magma{0x000004, 0x090720, 0x1a1042, 0x311165, 0x4a1079, 0x621980,
                              0x792282, 0x912b81, 0xaa337d, 0xc23b75, 0xd9466b, 0xec5860,
                              0xf7725c, 0xfc8e64, 0xfeaa74, 0xfec68a, 0xfde2a3, 0xfcfdbf};

Vec3 unpack(std::uint32_t rgb) {
  return Vec3(rgb >> 16 & 255u, rgb >> 8 & 255u, rgb & 255u) / 255.0f;
}

Vec3 interpolate(const ControlPoints& points, float t) {
  const float position = t * static_cast<float>(points.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(position), points.size() - 2);
  const float share = position - static_cast<float>(below);
  return glm::mix(unpack(points[below]), unpack(points[below + 1]), share);
}

}  // namespace

std::span<const std::string_view> color_map_names() {
  static constexpr std::array<std::string_view, 4> names{"viridis", "cividis", "magma", "grey"};
  return names;
}

Vec3 sample(ColorMap map, float t) {
  t = t > 0.0f ? std::min(t, 1.0f) : 0.0f;
  switch (map) {
    case ColorMap::viridis:
      return interpolate(viridis, t);
    case ColorMap::cividis:
      return interpolate(cividis, t);
    case ColorMap::magma:
      return interpolate(magma, t);
    case ColorMap::grey:
      break;
  }
  return Vec3(t);
}

}  // namespace bspview
