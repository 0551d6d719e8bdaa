#pragma once

#include "core/math/vec.h"

namespace bspview {

/// Point light without fall-off. Its intensity is `color` / (2 sqrt(number of lights)).
struct Light {
  Vec3 position{0.0f};
  Vec3 color{1.0f};

  bool operator==(const Light&) const = default;
};

}  // namespace bspview
