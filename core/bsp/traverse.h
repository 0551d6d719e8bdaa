#pragma once

#include "core/bsp/traversal.h"
#include "core/bsp/traverse_havran.h"
#include "core/bsp/traverse_robust.h"
#include "core/bsp/traverse_sung_shirley.h"

namespace bspview {

/// Walks the tree by the traversal that is set; see traverse_robust for `leaf` and the result.
template <class Leaf, class Observer>
std::uint32_t traverse(Traversal traversal, const Tree& tree, const Ray& ray, Leaf&& leaf,
                       Observer& observer) {
  const RayWalk walk(ray);
  switch (traversal) {
    case Traversal::sung_shirley:
      return traverse_sung_shirley(tree, walk, leaf, observer);
    case Traversal::havran:
      return traverse_havran(tree, walk, leaf, observer);
    case Traversal::robust:
      break;
  }
  return traverse_robust(tree, walk, leaf, observer);
}

}  // namespace bspview
