#pragma once

#include <cstdint>

namespace bspview {

/// Eight triangles side by side, for one ray that tests them all at once. A slot without one holds
/// NaN, which no ray hits.
struct alignas(64) TriangleBlock {
  static constexpr int width = 8;

  float vertices[3][3][width];  ///< vertex, axis, slot
  std::uint32_t object[width];  ///< ids
};

}  // namespace bspview
