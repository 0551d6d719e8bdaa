#pragma once

#include "core/math/aabb.h"
#include "core/math/ray.h"

namespace bspview {

/// View after the `v` record of NFF.
struct Camera {
  Vec3 from{0.0f, 0.0f, 1.0f};
  Vec3 at{0.0f};
  Vec3 up{0.0f, 1.0f, 0.0f};
  float angle_degrees = 45.0f;  ///< full vertical angle between the centres of the outermost rows
  float hither = 0.0f;          ///< kept for the file; rays start at `from`
  int width = 512;              ///< pixels
  int height = 512;

  bool operator==(const Camera&) const = default;
};

/// A camera whose picture, width : height = `aspect`, is filled by `box`, seen from
/// `direction` (any length; towards the scene).
Camera frame_box(const Aabb& box, Vec3 direction, Vec3 up, float aspect = 1.0f);

/// The rays of one picture. Pixel coordinates grow to the right and downwards; pixel (i, j)
/// covers [i, i + 1] x [j, j + 1], so its centre is (i + 0.5, j + 0.5).
class PrimaryRays {
 public:
  PrimaryRays(const Camera& camera, int width, int height);

  /// Direction of length about 1, from the eye.
  Ray ray(float x, float y) const { return {from_, corner_ + x * right_ + y * down_}; }

  /// Pixel coordinates of a point, and its depth along the view axis in world units
  /// (<= 0: behind the eye, x and y are then meaningless).
  Vec3 project(Vec3 point) const;

 private:
  Vec3 from_, corner_, right_, down_;
  Vec3d forward_axis_, right_axis_, down_axis_;
  double pixel_ = 0.0;  // side of a pixel at distance 1
  double half_width_ = 0.0, half_height_ = 0.0;
};

}  // namespace bspview
