#pragma once

#include "core/scene/camera.h"

namespace bspview {

/// World space to pixels of a width x height picture of `camera`, linear in homogeneous
/// coordinates, so that lines can be clipped behind the eye as well.
class ScreenTransform {
 public:
  ScreenTransform(const Camera& camera, int width, int height);

  /// (x w, y w, w): the ray of PrimaryRays through pixel coordinates (x, y) reaches `point` at
  /// t = w. Not in front of the eye: w <= 0.
  Vec3 homogeneous(Vec3 point) const {
    const Vec3 offset = point - eye_;
    return {glm::dot(x_row_, offset), glm::dot(y_row_, offset), glm::dot(w_row_, offset)};
  }

  Vec3 eye() const { return eye_; }
  int width() const { return width_; }
  int height() const { return height_; }

  /// Side of a square pixel at t = 1, in world units; a pixel at t is t times as large.
  float pixel_size() const { return pixel_size_; }

 private:
  int width_, height_;
  float pixel_size_;
  Vec3 eye_, x_row_, y_row_, w_row_;
};

}  // namespace bspview
