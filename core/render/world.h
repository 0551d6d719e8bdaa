#pragma once

#include "core/bsp/tree.h"
#include "core/scene/scene.h"

namespace bspview {

/// What rays are traced against. Both outlive every call.
struct World {
  const Scene& scene;
  const Tree& tree;
};

}  // namespace bspview
