#pragma once

#include "core/math/aabb.h"

namespace bspview {

/// Its magnitude; of a box that is not empty.
inline float largest_coordinate(const Aabb& box) {
  return largest_component(glm::max(magnitudes(box.lo), magnitudes(box.hi)));
}

}  // namespace bspview
