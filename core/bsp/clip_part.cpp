#include "core/bsp/clip_part.h"

namespace bspview {

Aabb clipped_box(const BuildJob& job, std::uint32_t object, const Aabb& cell) {
  return intersection(job.input.clip(object, cell), cell);
}

bool find_outline(const BuildJob& job, std::uint32_t object, const Aabb& cell, Outline& part) {
  if (!job.input.corners) return false;
  const std::span<const Vec3> polygon = job.input.corners(object);
  return !polygon.empty() &&
         find_outline(polygon, job.input.boxes[object], cell, job.clip_margin, part);
}

bool divide(const BuildJob& job, const Outline& part, const CellSplit& split,
            const OutlineSides& sides) {
  return divide(part, {split.axis, split.position, job.clip_margin}, sides);
}

Aabb box_of_part(const BuildJob& job, const Outline& part, std::uint32_t object, const Aabb& cell) {
  return intersection(box_of(part, job.clip_margin), intersection(job.input.boxes[object], cell));
}

SideBoxes clip_sides(const BuildJob& job, std::uint32_t object, const CellSplit& split) {
  Outline whole, left, right;
  if (!find_outline(job, object, split.cell, whole) || !divide(job, whole, split, {left, right})) {
    return {clipped_box(job, object, split.cells.left),
            clipped_box(job, object, split.cells.right)};
  }
  return {box_of_part(job, left, object, split.cells.left),
          box_of_part(job, right, object, split.cells.right)};
}

}  // namespace bspview
