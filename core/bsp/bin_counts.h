#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/bsp/deferred_leaf.h"

namespace bspview {

/// Bins of equal width on the three axes of a cell, and how many boxes begin and end in each.
struct BinCounts {
  static constexpr int bins = 64;
  using ByAxis = std::array<std::uint32_t, 4>;  ///< the last one counts for nothing

  explicit BinCounts(const Aabb& cell);
  void count(std::span<const ObjectPart> parts);
  void add(const BinCounts& other);

  std::array<ByAxis, bins> starts{}, ends{};

  /// As x, y, z, 0, 0, x, y, z: in vectors, for the lower sides of a box and for the upper ones.
  struct Scale {
    alignas(16) float lo[8]{}, per_width[8]{};
  };
  Scale scale;
};

}  // namespace bspview
