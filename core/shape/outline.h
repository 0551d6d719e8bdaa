#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/raw_vector.h"
#include "core/math/aabb.h"

namespace bspview {

/// In double, in the lanes of a vector; the last one is 0.
using OutlineCorner = std::array<double, 4>;

/// The part of a polygon in a cell while cell after cell is cut in two; no corners where nothing is
/// left. Of a concave polygon it is one outline, too, with edges to and fro along the cuts between
/// what lies apart.
using Outline = std::span<const OutlineCorner>;

/// A box in the lanes of vectors. The fourth lanes are the caller's; divide() hands them to both
/// sides.
struct alignas(32) LaneBox {
  float lo[4], hi[4];
};
inline LaneBox lane_box(const Aabb& box, float fourth = 0.0f) {
  return {{box.lo.x, box.lo.y, box.lo.z, fourth}, {box.hi.x, box.hi.y, box.hi.z, fourth}};
}
inline Aabb aabb(const LaneBox& box) {
  return {{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}};
}

/// How much farther than asked for outlines and their boxes reach, so that an outline is empty only
/// where the polygon is not, and its box holds the part. All polygons and cells lie within `box`; a
/// cut is off by less than 2^-50 of the largest coordinate, and there are fewer than 72.
double outline_margin(const Aabb& box);

/// Corners that an outline of `corners` has on one side of a plane, at most, and one that is
/// written before it is known whether it is kept: where every second one is kept and both of its
/// edges cross the plane, half of them with as many crossings as there are corners.
constexpr std::size_t outline_room(std::size_t corners) {
  return corners + corners / 2 + 1;
}

/// Where outlines are found; few corners need no heap.
class OutlineRoom {
 public:
  OutlineRoom() {}  // the corners stay undefined

  /// Of so many corners; what was there is lost.
  OutlineCorner* of(std::size_t corners) {
    if (corners <= few_.size()) return few_.data();
    many_.resize(corners);
    return many_.data();
  }

 private:
  std::array<OutlineCorner, 24> few_;
  RawVector<OutlineCorner> many_;
};
struct OutlineRooms {
  OutlineRoom first, second;
};

/// The part of a polygon with box `whole` in `cell`; it lies in one of the rooms.
[[nodiscard]] Outline find_outline(std::span<const Vec3> polygon, const Aabb& whole,
                                   const Aabb& cell, double margin, OutlineRooms& rooms);

/// A plane across an axis, and the margin of outlines.
struct OutlineCut {
  int axis;
  float position;
  double margin;
};

struct OutlineSides {
  Outline left, right;
};
struct LaneBoxes {
  LaneBox &left, &right;
};

/// Divides an outline within `box`. The sides lie in `to`, where there is room for
/// 2 outline_room(part.size()) corners. Writes their boxes: rounded outwards, with the margin, but
/// within `box` and not beyond the plane. A side whose box is empty is so, too.
[[nodiscard]] OutlineSides divide(Outline part, const LaneBox& box, const OutlineCut& cut,
                                  OutlineCorner* to, const LaneBoxes& boxes);

/// Rounded outwards, with the margin; empty for an empty outline.
Aabb box_of(Outline part, double margin);

}  // namespace bspview
