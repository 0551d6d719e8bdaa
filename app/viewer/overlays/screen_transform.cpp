#include "app/viewer/overlays/screen_transform.h"

#include <algorithm>

namespace bspview {

// Rays have directions corner + x right + y down, so a point eye + w (corner + x right + y down)
// has the coordinates (x w, y w, w) in the basis (right, down, corner): Cramer's rule.
ScreenTransform::ScreenTransform(const Camera& camera, int width, int height)
    : width_(std::max(width, 1)), height_(std::max(height, 1)) {
  const PrimaryRays rays(camera, width_, height_);
  const auto columns = static_cast<float>(width_), rows = static_cast<float>(height_);
  const Vec3d corner = rays.ray(0.0f, 0.0f).direction;
  const Vec3d right = (Vec3d(rays.ray(columns, 0.0f).direction) - corner) / double(columns);
  const Vec3d down = (Vec3d(rays.ray(0.0f, rows).direction) - corner) / double(rows);
  const double determinant = glm::dot(right, glm::cross(down, corner));
  eye_ = rays.ray(0.0f, 0.0f).origin;
  x_row_ = Vec3(glm::cross(down, corner) / determinant);
  y_row_ = Vec3(glm::cross(corner, right) / determinant);
  w_row_ = Vec3(glm::cross(right, down) / determinant);
  pixel_size_ = static_cast<float>(glm::length(right));
}

}  // namespace bspview
