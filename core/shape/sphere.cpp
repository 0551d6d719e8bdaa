#include "core/shape/sphere.h"

#include <cmath>

#include "core/math/float_error.h"

namespace bspview {

Aabb sphere_bounds(const Sphere& sphere) {
  const double radius = std::abs(static_cast<double>(sphere.radius));
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = round_down(sphere.centre[axis] - radius);
    box.hi[axis] = round_up(sphere.centre[axis] + radius);
  }
  return box;
}

Aabb clip_sphere(const Sphere& sphere, const Aabb& cell) {
  const Aabb box = intersection(sphere_bounds(sphere), cell);
  if (box.empty()) return Aabb{};
  // Squared distances from the centre to the nearest and the farthest point of the cell.
  double nearest = 0.0, farthest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = static_cast<double>(cell.lo[axis]) - sphere.centre[axis];
    const double above = static_cast<double>(cell.hi[axis]) - sphere.centre[axis];
    const double near = below > 0.0 ? below : above < 0.0 ? above : 0.0;
    const double far = std::max(std::abs(below), std::abs(above));
    nearest += near * near;
    farthest += far * far;
  }
  const double r2 = static_cast<double>(sphere.radius) * sphere.radius;
  // Hit points are rounded to float: what they may be off the surface by must not drop the object.
  const double slack = 0x1p-20 * r2;
  return nearest > r2 + slack || farthest < r2 - slack ? Aabb{} : box;
}

}  // namespace bspview
