#pragma once

#include <cstdint>

#include "core/math/vec.h"

namespace bspview {

// Colours in 32 bits, 8 a component: red in the lowest byte, alpha in the highest.

/// Components in [0, 1], clamped; not premultiplied, as in a Line.
[[nodiscard]] std::uint32_t pack_color(Vec3 color, float alpha = 1.0f);

/// All four components times `factor` / 255, rounded to nearest.
[[nodiscard]] inline std::uint32_t scale_color(std::uint32_t color, std::uint32_t factor) {
  // Two components at once: p / 255 = (p + p / 256 + 1/2) / 256 for every product p of two bytes.
  const auto scale_two = [&](std::uint32_t components) {
    const std::uint32_t product = components * factor + 0x00800080u;
    return (product + (product >> 8 & 0x00ff00ffu)) >> 8 & 0x00ff00ffu;
  };
  return scale_two(color & 0x00ff00ffu) | scale_two(color >> 8 & 0x00ff00ffu) << 8;
}

/// The same colour with its components multiplied by its alpha, as in a Layer.
[[nodiscard]] inline std::uint32_t premultiply(std::uint32_t color) {
  return scale_color(color | 0xff000000u, color >> 24);
}

/// Premultiplied `above` laid over premultiplied `below`.
[[nodiscard]] inline std::uint32_t blend_over(std::uint32_t above, std::uint32_t below) {
  return above + scale_color(below, 255u - (above >> 24));
}

}  // namespace bspview
