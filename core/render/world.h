#pragma once

#include "core/bsp/tree.h"
#include "core/scene/scene.h"

namespace bspview {

class Accelerator;
class LazyTree;

/// What rays are traced against. Everything outlives every call.
struct World {
  const Scene& scene;
  const Tree& tree;
  const Accelerator* accelerator = nullptr;  ///< of both; null: rays go through the binary tree
  const LazyTree* lazy = nullptr;  ///< whose upper part `tree` is; null: `tree` is all there is
};

}  // namespace bspview
