#pragma once

#include "core/bsp/build_job.h"
#include "core/shape/outline.h"

namespace bspview {

/// Box of the part of `object` inside `cell`; empty when nothing is inside.
Aabb clipped_box(const BuildJob& job, std::uint32_t object, const Aabb& cell);

/// The outline of an object inside `cell`; false when it has none.
[[nodiscard]] bool find_outline(const BuildJob& job, std::uint32_t object, const Aabb& cell,
                                Outline& part);

/// Boxes of the parts of an object on both sides of a plane; empty where nothing is.
struct SideBoxes {
  Aabb left, right;
};
SideBoxes clip_sides(const BuildJob& job, std::uint32_t object, const CellSplit& split);

/// Divides the outline of an object in the cell; false when a side has too many corners to hold.
[[nodiscard]] bool divide(const BuildJob& job, const Outline& part, const CellSplit& split,
                          const OutlineSides& sides);

/// Box of an outline of `object` inside `cell`; empty when nothing is inside.
Aabb box_of_part(const BuildJob& job, const Outline& part, std::uint32_t object, const Aabb& cell);

}  // namespace bspview
