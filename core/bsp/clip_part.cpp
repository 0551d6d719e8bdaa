#include "core/bsp/clip_part.h"

namespace bspview {

Aabb clipped_box(const BuildJob& job, std::uint32_t object, const Aabb& cell) {
  return intersection(job.input.clip(object, cell), cell);
}

std::optional<Outline> find_outline(const BuildJob& job, std::uint32_t object, const Aabb& cell,
                                    OutlineRooms& rooms) {
  if (!job.input.corners) return {};
  const std::span<const Vec3> polygon = job.input.corners(object);
  if (polygon.empty()) return {};
  return find_outline(polygon, job.input.boxes[object], cell, job.clip_margin, rooms);
}

SideBoxes clip_sides(const BuildJob& job, std::uint32_t object, const CellSplit& split) {
  OutlineRooms rooms;
  const std::optional<Outline> whole = find_outline(job, object, split.cell, rooms);
  if (!whole) {
    return {clipped_box(job, object, split.cells.left),
            clipped_box(job, object, split.cells.right)};
  }
  OutlineRoom room;
  LaneBox left, right;
  const OutlineSides sides =
      divide(*whole, lane_box(intersection(job.input.boxes[object], split.cell)),
             {split.axis, split.position, job.clip_margin},
             room.of(2 * outline_room(whole->size())), {left, right});
  return {sides.left.empty() ? Aabb() : aabb(left), sides.right.empty() ? Aabb() : aabb(right)};
}

}  // namespace bspview
