#pragma once

#include <cstdint>
#include <span>

#include "app/viewer/overlays/layer.h"

namespace bspview {

/// Borders of leaf cells on the visible surfaces: `color` (RGBA as in Line) where the leaf of a
/// pixel (Frame::leaf, row-major, width x height) is another than that of its right or lower
/// neighbour. O(pixels), whatever the size of the tree.
[[nodiscard]] Layer leaf_borders(std::span<const std::uint32_t> leaf, int width, int height,
                                 std::uint32_t color);

}  // namespace bspview
