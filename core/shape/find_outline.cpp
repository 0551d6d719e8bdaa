// After Sutherland & Hodgman 1974, "Reentrant polygon clipping".

#include <utility>

#include "core/shape/outline.h"

namespace bspview {
namespace {

using Corner = OutlineCorner;

Corner wide(const Vec3& p) {
  return {p.x, p.y, p.z, 0.0};
}
const Corner& wide(const Corner& p) {
  return p;
}

/// Half-space of the points p with sign * p[axis] >= limit.
struct HalfSpace {
  int axis;
  double sign, limit;
  double removed;  // length of the polygon's box that is outside

  double height(const Vec3& p) const { return sign * double{component(p, axis)} - limit; }
  double height(const Corner& p) const { return sign * p[static_cast<std::size_t>(axis)] - limit; }
};

/// The half-spaces that cut a polygon with box `whole` down to `cell`, the one that removes most
/// first.
class Cuts {
 public:
  Cuts(const Aabb& whole, const Aabb& cell, double margin) {
    for (int axis = 0; axis < 3; ++axis) {
      const double lo = component(cell.lo, axis), hi = component(cell.hi, axis);
      const double below = lo - component(whole.lo, axis), above = component(whole.hi, axis) - hi;
      if (below > 0.0) add({axis, 1.0, lo - margin, below});
      if (above > 0.0) add({axis, -1.0, -hi - margin, above});
    }
  }
  std::span<const HalfSpace> all() const { return std::span(halves_).first(count_); }

 private:
  void add(const HalfSpace& half) {
    halves_[count_] = half;
    if (half.removed > halves_[0].removed) std::swap(halves_[0], halves_[count_]);
    ++count_;
  }

  std::array<HalfSpace, 6> halves_;
  std::size_t count_ = 0;
};

Corner crossing(const Corner& p, const Corner& q, double share) {
  return {p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]), p[2] + share * (q[2] - p[2]),
          0.0};
}

/// Writes what is left of the corners.
template <class Point>
Outline clip(std::span<const Point> corners, const HalfSpace& half, OutlineRoom& room) {
  Corner* const first = room.of(outline_room(corners.size()));
  Corner* to = first;
  const Point* p = &corners.back();
  double p_height = half.height(*p);
  for (const Point& q : corners) {
    const double height = half.height(q);
    if ((p_height >= 0.0) != (height >= 0.0)) {
      *to++ = crossing(wide(*p), wide(q), p_height / (p_height - height));
    }
    if (height >= 0.0) *to++ = wide(q);
    p = &q;
    p_height = height;
  }
  return {first, to};
}

Outline widen(std::span<const Vec3> polygon, OutlineRoom& room) {
  Corner* const corners = room.of(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) corners[i] = wide(polygon[i]);
  return {corners, polygon.size()};
}

}  // namespace

Outline find_outline(std::span<const Vec3> polygon, const Aabb& whole, const Aabb& cell,
                     double margin, OutlineRooms& rooms) {
  const Cuts cuts(whole, cell, margin);
  if (cuts.all().empty()) return widen(polygon, rooms.first);
  Outline part = clip(polygon, cuts.all()[0], rooms.first);
  OutlineRoom *room = &rooms.second, *spare = &rooms.first;
  for (const HalfSpace& half : cuts.all().subspan(1)) {
    if (part.empty()) break;
    part = clip(part, half, *room);
    std::swap(room, spare);
  }
  return part;
}

}  // namespace bspview
