#pragma once

// Interval traversal: the ends of the ray's interval in a cell are moved outwards by what they and
// the planes compared with them may be off, so that no cell is skipped that the ray touches. The
// bounds are Ize's (2013, "Robust BVH Ray Traversal", JCGT 2(2)), applied to split planes.

#include "core/bsp/ray_walk.h"

namespace bspview {

/// Visits the leaves along the ray, front to back. leaf(index, node) tests the objects and answers
/// the distance of the best hit so far, in t of the ray (inf: none, stop_walk: enough). A hit
/// counts wherever it lies; the walk ends when it is nearer than the next cell.
/// Returns the leaf visited last, which holds the best hit; no_leaf when none was.
template <class Leaf, class Observer>
std::uint32_t traverse_robust(const Tree& tree, const RayWalk& ray, Leaf&& leaf,
                              Observer& observer) {
  // Cells overlap by their borders: one further down the stack may be entered 2 plane_error before
  // the one on top. Polygons off their plane are met up to longest_passage (polygon.h) too soon.
  constexpr double sooner = 1.0 - 8.0 * plane_error, later = 1.0 + 8.0 * plane_error;
  RayInterval interval = root_interval(tree, ray);
  if (!(interval.enter <= interval.exit)) return no_leaf;
  interval.enter -= plane_error * std::abs(interval.enter);
  interval.exit += plane_error * std::abs(interval.exit);
  WalkStack stack;
  std::uint32_t index = 0;
  for (;;) {
    const Node node = tree.nodes[index];
    if (node.is_leaf()) {
      observer.leaf(index, interval);
      const double best = leaf(index, node);
      if (stack.empty()) return index;
      const auto next = stack.pop();
      const double reach = best * (best < 0.0 ? sooner : later);
      if (reach < next.interval.enter * ray.scale) return index;
      index = next.node;
      interval = next.interval;
      continue;
    }
    const float t = ray.plane_distance(node);
    const NearFar child = near_far(node, ray.goes_right(node.axis()));
    // Comparisons are written so that NaN (the ray lies in the plane) visits both, unclipped.
    if (t > interval.exit) {
      observer.inner(index, node, StepKind::near_only, t, interval);
      index = child.near;
    } else if (t < interval.enter) {
      observer.inner(index, node, StepKind::far_only, t, interval);
      index = child.far;
    } else {
      observer.inner(index, node, StepKind::both, t, interval);
      const float margin = 2.0f * plane_error * std::abs(t);
      const float t_low = t - margin, t_high = t + margin;
      const float far_enter = t_low > interval.enter ? t_low : interval.enter;
      stack.push(child.far, {far_enter, interval.exit});
      interval.exit = t_high < interval.exit ? t_high : interval.exit;
      index = child.near;
    }
  }
}

}  // namespace bspview
