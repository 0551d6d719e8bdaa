#pragma once

// After Havran, Kopal, Bittner & Zara 1997, "Fast robust BSP tree traversal algorithm for ray
// tracing", Journal of Graphics Tools 2(4): algorithm TA-B.

#include "core/bsp/ray_walk.h"

namespace bspview {

/// Where the ray crosses the border of a cell.
struct BorderPoint {
  float t;
  Vec3 point;
};

/// As published: children are chosen by comparing the coordinates of the entry and exit points with
/// the plane, and a distance is computed only when both are visited; the exit point's coordinate on
/// the split axis is set to the plane exactly. Answers and returns as traverse_robust does.
template <class Leaf, class Observer>
std::uint32_t traverse_havran(const Tree& tree, const RayWalk& ray, Leaf&& leaf,
                              Observer& observer) {
  const RayInterval root = root_interval(tree, ray);
  if (!(root.enter <= root.exit)) return no_leaf;
  const auto at = [&](float t) { return BorderPoint{t, ray.origin + t * ray.direction}; };
  struct Entry {
    std::uint32_t node;
    BorderPoint exit;
  };
  std::array<Entry, depth_cap + 2> stack;
  int depth = 0;
  BorderPoint enter = at(root.enter), exit = at(root.exit);
  std::uint32_t index = 0;
  for (;;) {
    const Node node = tree.nodes[index];
    const RayInterval interval{enter.t, exit.t};
    if (node.is_leaf()) {
      observer.leaf(index, interval);
      const double best = leaf(index, node);
      if (best <= exit.t * ray.scale || depth == 0) return index;
      enter = exit;
      exit = stack[--depth].exit;
      index = stack[depth].node;
      continue;
    }
    const int axis = node.axis();
    const float split = node.split();
    const float t = ray.plane_distance(node);
    const bool enter_left = component(enter.point, axis) <= split;
    const bool exit_left = component(exit.point, axis) <= split;
    const bool start_right = component(enter.point, axis) == split && !exit_left;
    const NearFar child = near_far(node, enter_left);
    if (start_right) {
      observer.inner(index, node, StepKind::far_only, t, interval);
      index = child.far;
    } else if (enter_left == exit_left) {
      observer.inner(index, node, StepKind::near_only, t, interval);
      index = child.near;
    } else {
      observer.inner(index, node, StepKind::both, t, interval);
      stack[depth++] = {child.far, exit};
      exit = at(t);
      exit.point[axis] = split;
      index = child.near;
    }
  }
}

}  // namespace bspview
