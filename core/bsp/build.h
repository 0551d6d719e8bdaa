#pragma once

#include <functional>
#include <limits>
#include <span>

#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/bsp/inner_objects.h"
#include "core/bsp/tree.h"

namespace bspview {

/// Whether an object with that box is put into leaves: not when it is empty, infinite or NaN.
inline bool is_placeable(const Aabb& box) {
  constexpr float most = std::numeric_limits<float>::max();
  const auto is_range = [](float lo, float hi) { return -most <= lo && lo <= hi && hi <= most; };
  return is_range(box.lo.x, box.hi.x) && is_range(box.lo.y, box.hi.y) &&
         is_range(box.lo.z, box.hi.z);
}

/// Box of the part of object `object` inside `cell`, rounded outwards; empty when there is none.
using ClipFunction = std::function<Aabb(std::uint32_t object, const Aabb& cell)>;

/// Corners of an object that is a polygon, concave or not; none for any other.
using CornersFunction = std::function<std::span<const Vec3>(std::uint32_t object)>;

/// Cost of testing an object. Above 0.
using TestCostFunction = std::function<float(std::uint32_t object)>;

/// What a builder knows of the objects. The functions are called from several threads.
struct BuildInput {
  std::span<const Aabb> boxes;      ///< one an object; not placeable: the object is in no leaf
  ClipFunction clip;                ///< null: trees are built without
  CornersFunction corners = {};     ///< what the builder may clip itself, several times as fast
  float cost_intersection = 1.5f;   ///< C_I of trees whose parameters have none: a mean
  TestCostFunction test_cost = {};  ///< C_I of each; null: the mean
};

/// What a build answers that is out of memory.
inline Error no_memory_for_tree() {
  return Error{"not enough memory for the tree"};
}

/// Builds a tree, all of it. The result depends on no thread count and no timing. The maximal depth
/// is clamped to depth_cap, the leaf size to at least 1; where the memory limit leaves no room for
/// two children, a node becomes a leaf. Fails with the error "stopped" soon (within milliseconds)
/// after a stop is requested, and when memory runs out. Fills `inner`, unless one of the limits is
/// passed.
Result<Tree> build_tree(const BuildInput& input, const BuildParams& params, const Watch& watch = {},
                        InnerObjects* inner = nullptr);

}  // namespace bspview
