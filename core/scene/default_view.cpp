#include "core/scene/default_view.h"

#include <cmath>

namespace bspview {

Camera make_default_view(const Aabb& bounds) {
  return frame_box(bounds, {-2.1f, -1.3f, -1.7f}, {0.0f, 0.0f, 1.0f});
}

Light make_default_light(const Camera& camera) {
  // Half the distance to the target up, and a quarter to the left.
  const Vec3 view = camera.at - camera.from;
  const float height = 0.5f * glm::length(view);
  const Vec3 up = glm::normalize(camera.up);
  const Vec3 left = glm::cross(up, 0.25f * view);
  const Vec3 position = camera.from + height * up + left;
  // Not so for an up vector without direction.
  const bool finite = std::isfinite(position.x + position.y + position.z);
  return {.position = finite ? position : camera.from};
}

}  // namespace bspview
