#pragma once

// What every traversal shares: the ray as it walks, its interval in the root, its stack.

#include <array>
#include <cmath>
#include <limits>

#include "core/bsp/observer.h"
#include "core/bsp/tree.h"
#include "core/math/float_error.h"
#include "core/math/ray.h"
#include "core/math/strict_floats.h"

namespace bspview {

/// What a leaf answers when nothing behind it matters any more.
inline constexpr double stop_walk = -std::numeric_limits<double>::infinity();

/// Bound on the relative error of t = (plane - origin) * (1 / direction), counted twice: once for
/// each of two planes that are compared.
inline constexpr float plane_error = 2.0f * gamma_error(3);

/// A ray with the reciprocals of its direction. A component of 0 gives a reciprocal of inf with
/// the sign of the zero: planes beside the ray are then at +-inf, and at NaN when the origin lies
/// in the plane. Directions far from length 1 are brought there by an exact power of two, so that
/// no reciprocal of a component that matters overflows; `scale` turns t of the walk into t of the
/// ray.
struct RayWalk {
  explicit RayWalk(const Ray& ray) : origin(ray.origin), direction(ray.direction) {
    const float size = largest_component(magnitudes(direction));
    if (!(size > 0x1p-20f && size < 0x1p20f)) bring_to_length_one(size);
    inverse = 1.0f / direction;
    t_min = static_cast<float>(ray.t_min / scale);
    t_max = static_cast<float>(ray.t_max / scale);
  }

  /// By the sign of the reciprocal: beside a component of +0 every plane to the right is at +inf.
  bool goes_right(int axis) const { return component(inverse, axis) > 0.0f; }
  float plane_distance(const Node& node) const {
    return (node.split() - component(origin, node.axis())) * component(inverse, node.axis());
  }

  Vec3 origin, direction, inverse;
  float t_min, t_max;
  double scale = 1.0;  ///< t of the ray = scale * t of the walk

 private:
  void bring_to_length_one(float size) {
    if (!(size > 0.0f && size < std::numeric_limits<float>::infinity())) return;
    const int exponent = std::ilogb(size);
    for (int axis = 0; axis < 3; ++axis) direction[axis] = std::scalbn(direction[axis], -exponent);
    scale = std::ldexp(1.0, -exponent);
  }
};

/// The part of the ray inside the tree's box, widened by what rounding may have cut off; empty
/// (enter > exit) for a ray that misses it and for one that is no ray: a direction of 0, anything
/// NaN or infinite but t_max.
inline RayInterval root_interval(const Tree& tree, const RayWalk& ray) {
  constexpr RayInterval none{1.0f, 0.0f};
  const float direction_size = largest_component(magnitudes(ray.direction));
  const Vec3 finite = 0.0f * (ray.origin + ray.direction);
  if (!(direction_size > 0.0f) || finite != Vec3(0.0f)) return none;
  RayInterval interval{ray.t_min, ray.t_max};
  if (tree.naive) return interval;
  for (int axis = 0; axis < 3; ++axis) {
    const float a = (tree.box.lo[axis] - ray.origin[axis]) * ray.inverse[axis];
    const float b = (tree.box.hi[axis] - ray.origin[axis]) * ray.inverse[axis];
    if (std::isnan(a) || std::isnan(b)) continue;  // in the plane of a side: inside on this axis
    const float near = a < b ? a : b;
    const float far = a < b ? b : a;
    interval.enter = std::max(interval.enter, near - plane_error * std::abs(near));
    interval.exit = std::min(interval.exit, far + plane_error * std::abs(far));
  }
  return interval;
}

/// Far children still to visit, the nearest on top. Depth is capped, so it cannot overflow.
class WalkStack {
 public:
  struct Entry {
    std::uint32_t node;
    RayInterval interval;
  };
  void push(std::uint32_t node, RayInterval interval) { entries_[size_++] = {node, interval}; }
  Entry pop() { return entries_[--size_]; }
  bool empty() const { return size_ == 0; }

 private:
  std::array<Entry, depth_cap + 2> entries_;
  int size_ = 0;
};

/// Near child: the one that the ray is in before the plane.
struct NearFar {
  std::uint32_t near, far;
};
inline NearFar near_far(const Node& node, bool left_first) {
  return left_first ? NearFar{node.left(), node.right()} : NearFar{node.right(), node.left()};
}

}  // namespace bspview
