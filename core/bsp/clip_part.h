#pragma once

#include <optional>

#include "core/bsp/build_job.h"
#include "core/shape/outline.h"

namespace bspview {

/// Box of the part of `object` inside `cell`; empty when nothing is inside.
Aabb clipped_box(const BuildJob& job, std::uint32_t object, const Aabb& cell);

/// The outline of an object inside `cell`, which lies in the rooms; nothing when it has none.
[[nodiscard]] std::optional<Outline> find_outline(const BuildJob& job, std::uint32_t object,
                                                  const Aabb& cell, OutlineRooms& rooms);

/// Boxes of the parts of an object on both sides of a plane; empty where nothing is.
struct SideBoxes {
  Aabb left, right;
};
SideBoxes clip_sides(const BuildJob& job, std::uint32_t object, const CellSplit& split);

}  // namespace bspview
