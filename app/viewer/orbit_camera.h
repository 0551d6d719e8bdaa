#pragma once

#include "app/picture_size.h"
#include "core/math/aabb.h"
#include "core/scene/camera.h"

namespace bspview {

/// The viewer's camera: turns about a pivot with the scene's up staying up. All movements are
/// relative to the scene's size, so tiny and huge scenes feel alike. Pixel coordinates as in
/// PrimaryRays; a depth is Frame::distance under the cursor, or inf where nothing was hit: then
/// the depth of the pivot counts.
class OrbitCamera {
 public:
  /// `home` is the file's camera, `scene_box` what F frames.
  OrbitCamera(const Camera& home, const Aabb& scene_box);

  /// Exactly `home` as long as nothing moved (and after reset).
  [[nodiscard]] Camera camera() const;
  [[nodiscard]] Vec3 pivot() const { return Vec3(pivot_); }

  /// Turns about the pivot: a drag over the picture's height is half a turn. Never over the poles.
  void orbit(Vec2 drag_pixels, PictureSize size);
  /// The point at `depth` under `from_pixel` moves under `to_pixel`.
  void pan(Vec2 from_pixel, Vec2 to_pixel, float depth, PictureSize size);
  /// Moves towards (notches > 0) or away from the point at `depth` under `pixel`, which stays
  /// there.
  void dolly(float notches, Vec2 pixel, float depth, PictureSize size);
  /// Brings `point` to the centre of the picture and makes it the pivot.
  void recentre(Vec3 point);
  /// Shows the whole scene from the current direction.
  void frame(PictureSize size);
  /// Back to the file's camera.
  void reset();

 private:
  double depth_or_pivot(float depth) const;
  void keep_pivot_in_front(double depth);

  Camera home_;
  Aabb scene_box_;
  double scene_size_ = 1.0;  // diagonal of the scene
  bool moved_ = false;
  Vec3d eye_{0.0}, forward_{0.0, 0.0, -1.0}, up_{0.0, 1.0, 0.0}, pivot_{0.0};
  float angle_degrees_ = 45.0f;
};

}  // namespace bspview
