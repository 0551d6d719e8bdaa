#include "app/viewer/overlays/color_scale.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace bspview {

float position_on(const ColorScale& scale, float value) {
  const float range = scale.hi - scale.lo;
  if (!(range > 0.0f)) return 0.0f;
  const float above = std::clamp(value - scale.lo, 0.0f, range);
  if (scale.spacing == ColorScale::Spacing::linear) return above / range;
  return std::log1p(above) / std::log1p(range);
}

Vec3 color_at(const ColorScale& scale, float position) {
  constexpr float darkest = 0.2f;
  return sample(scale.map, darkest + (1.0f - darkest) * std::clamp(position, 0.0f, 1.0f));
}

}  // namespace bspview
