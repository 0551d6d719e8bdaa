#pragma once

#include <limits>

#include "core/math/vec.h"

namespace bspview {

/// Axis-aligned box, closed on all sides. The default one is empty (lo > hi on every axis).
struct Aabb {
  Vec3 lo{std::numeric_limits<float>::infinity()};
  Vec3 hi{-std::numeric_limits<float>::infinity()};

  bool operator==(const Aabb&) const = default;

  bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
  Vec3 extent() const { return hi - lo; }
  Vec3 centre() const { return 0.5f * (lo + hi); }

  void grow(Vec3 point) {
    lo = glm::min(lo, point);
    hi = glm::max(hi, point);
  }
  void grow(const Aabb& box) {
    lo = glm::min(lo, box.lo);
    hi = glm::max(hi, box.hi);
  }

  bool contains(Vec3 p) const {
    return lo.x <= p.x && p.x <= hi.x && lo.y <= p.y && p.y <= hi.y && lo.z <= p.z && p.z <= hi.z;
  }
  bool contains(const Aabb& box) const { return contains(box.lo) && contains(box.hi); }
};

inline Aabb intersection(const Aabb& a, const Aabb& b) {
  return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)};
}

/// In double: exact enough to add up the volumes of a million cells.
inline double volume(const Aabb& box) {
  const Vec3d d = Vec3d(box.hi) - Vec3d(box.lo);
  return d.x * d.y * d.z;
}

/// Half of the surface area: the SAH needs ratios only.
inline float half_area(const Aabb& box) {
  const Vec3 d = box.extent();
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

}  // namespace bspview
