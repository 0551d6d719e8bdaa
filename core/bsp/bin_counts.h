#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/bsp/deferred_leaf.h"

namespace bspview {

/// Bins of equal width on the three axes of a cell, and how many boxes begin and end in each.
struct BinCounts {
  static constexpr std::size_t fewest = 64, most = 256;
  using ByAxis = std::array<std::uint32_t, 4>;  ///< the last one counts for nothing

  /// As many bins as are worth their price for so many objects: one for every four.
  BinCounts(const Aabb& cell, std::size_t objects);
  void count(std::span<const ObjectPart> parts);
  void add(const BinCounts& other);

  std::size_t bins;
  std::array<ByAxis, most> starts, ends;  ///< of each bin; none behind the last

  /// As x, y, z, 0, 0, x, y, z: in vectors, for the lower sides of a box and for the upper ones.
  struct Scale {
    alignas(16) float lo[8]{}, per_width[8]{};
  };
  Scale scale;
};

}  // namespace bspview
