#pragma once

#include <array>
#include <span>

#include "core/math/aabb.h"

namespace bspview {

/// The part of a polygon in a cell, in double, while cell after cell is cut in two. Of a concave
/// polygon it is one outline, too, with edges to and fro along the cuts between what lies apart.
struct Outline {
  /// Enough for a triangle in a cell, which has nine corners, and what rounding can add.
  static constexpr std::size_t most_corners = 12;

  /// In the lanes of a vector; the last one is 0.
  using Corner = std::array<double, 4>;

  std::size_t size = 0;
  /// A corner is written before it is known whether it is kept: two more than counted.
  alignas(16) std::array<Corner, most_corners + 2> corners;
};

/// How much farther than asked for outlines and their boxes reach, so that an outline is empty only
/// where the polygon is not, and its box holds the part. All polygons and cells lie within `box`; a
/// cut is off by less than 2^-50 of the largest coordinate, and there are fewer than 72.
double outline_margin(const Aabb& box);

/// The part of a polygon with box `whole` in `cell`; false when it has too many corners.
[[nodiscard]] bool find_outline(std::span<const Vec3> polygon, const Aabb& whole, const Aabb& cell,
                                double margin, Outline& part);

/// A plane across an axis, and the margin of outlines.
struct OutlineCut {
  int axis;
  double position, margin;
};

/// The parts of an outline on both sides of a plane; false when one has too many corners.
struct OutlineSides {
  Outline &left, &right;
};
[[nodiscard]] bool divide(const Outline& part, const OutlineCut& cut, const OutlineSides& sides);

/// Rounded outwards, with the margin; empty for an empty outline.
Aabb box_of(const Outline& part, double margin);

}  // namespace bspview
