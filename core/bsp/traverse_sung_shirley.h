#pragma once

// After Sung & Shirley 1992, "Ray Tracing with the BSP Tree", Graphics Gems III, chapter 6.4.

#include "core/bsp/ray_walk.h"

namespace bspview {

/// As published: the near child is the one on the origin's side of the plane, and distances are
/// taken at face value. Rays that graze a plane or lie in one can lose a hit. Answers and returns
/// as traverse_robust does.
template <class Leaf, class Observer>
std::uint32_t traverse_sung_shirley(const Tree& tree, const RayWalk& ray, Leaf&& leaf,
                                    Observer& observer) {
  RayInterval interval = root_interval(tree, ray);
  if (!(interval.enter <= interval.exit)) return no_leaf;
  WalkStack stack;
  std::uint32_t index = 0;
  for (;;) {
    const Node node = tree.nodes[index];
    if (node.is_leaf()) {
      observer.leaf(index, interval);
      const double best = leaf(index, node);
      if (best <= interval.exit * ray.scale || stack.empty()) return index;
      const auto next = stack.pop();
      index = next.node;
      interval = next.interval;
      continue;
    }
    const float t = (node.split() - ray.origin[node.axis()]) / ray.direction[node.axis()];
    const NearFar child = near_far(node, ray.origin[node.axis()] <= node.split());
    if (t > interval.exit || t < 0.0f) {
      observer.inner(index, node, StepKind::near_only, t, interval);
      index = child.near;
    } else if (t < interval.enter) {
      observer.inner(index, node, StepKind::far_only, t, interval);
      index = child.far;
    } else {
      observer.inner(index, node, StepKind::both, t, interval);
      stack.push(child.far, {t, interval.exit});
      interval.exit = t;
      index = child.near;
    }
  }
}

}  // namespace bspview
