#pragma once

#include <cstdint>
#include <vector>

#include "core/math/vec.h"

namespace bspview {

/// A straight line in world space.
struct Line {
  Vec3 from{0.0f}, to{0.0f};
  std::uint32_t color = 0xffffffffu;  ///< RGBA, red in the lowest byte
  float width = 1.0f;                 ///< pixels
};

/// What an overlay hands to whoever draws it.
using LineList = std::vector<Line>;

}  // namespace bspview
