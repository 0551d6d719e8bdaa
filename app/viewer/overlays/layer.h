#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bspview {

/// RGBA8 picture with premultiplied alpha, row-major, top row first, red in the lowest byte.
struct Layer {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;

  Layer() = default;
  Layer(int columns, int rows)
      : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * rows) {}
  bool operator==(const Layer&) const = default;
};

/// Lays `above` over `below`; both have the same size.
void lay_over(Layer& below, const Layer& above);

}  // namespace bspview
