#include "app/viewer/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bspview {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double highest = 89.5 * degree;         // of the view above or below the horizon
constexpr double dolly_factor = 0.85;             // of the distance, per notch of the wheel
constexpr double nearest = 1e-6, farthest = 1e3;  // distances, in sizes of the scene

/// `v` turned about the unit vector `axis` (Rodrigues' formula).
Vec3d rotated(Vec3d v, Vec3d axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
}

bool is_usable(double length) {
  return std::isfinite(length) && length > 0.0;
}

/// Diagonal of the scene; of a scene without extent, the distance that its camera looks at.
double size_of(const Aabb& box, const Camera& home) {
  const double diagonal = box.empty() ? 0.0 : glm::length(Vec3d(box.hi) - Vec3d(box.lo));
  if (is_usable(diagonal)) return diagonal;
  const double view = glm::length(Vec3d(home.at) - Vec3d(home.from));
  return is_usable(view) ? view : 1.0;
}

/// The file's up, or the picture's where the file's says nothing because it points along the view.
Vec3d up_of(const Camera& home, const PrimaryRays& rays) {
  constexpr double parallel = 1e-3;
  const Vec3d forward = glm::normalize(Vec3d(rays.ray(0.5f, 0.5f).direction));
  const double length = glm::length(Vec3d(home.up));
  if (is_usable(length)) {
    const Vec3d up = Vec3d(home.up) / length;
    if (glm::length(glm::cross(up, forward)) > parallel) return up;
  }
  return glm::normalize(Vec3d(rays.ray(0.5f, 0.0f).direction) -
                        Vec3d(rays.ray(0.5f, 1.0f).direction));
}

}  // namespace

OrbitCamera::OrbitCamera(const Camera& home, const Aabb& scene_box)
    : home_(home), scene_box_(scene_box), scene_size_(size_of(scene_box, home)) {
  reset();
}

void OrbitCamera::reset() {
  const PrimaryRays rays(home_, 1, 1);
  moved_ = false;
  eye_ = rays.ray(0.5f, 0.5f).origin;
  forward_ = glm::normalize(Vec3d(rays.ray(0.5f, 0.5f).direction));
  up_ = up_of(home_, rays);
  angle_degrees_ = home_.angle_degrees;
  // The file's point of view is often far from what is seen: then the nearest point of the view
  // axis to the scene's middle serves.
  pivot_ = home_.at;
  if (!scene_box_.empty() && !scene_box_.contains(home_.at)) {
    pivot_ = eye_ + glm::dot(Vec3d(scene_box_.centre()) - eye_, forward_) * forward_;
  }
  keep_pivot_in_front(scene_size_);
}

Camera OrbitCamera::camera() const {
  if (!moved_) return home_;
  Camera camera = home_;
  // Far enough for the direction to survive the rounding of both points to float.
  const double coordinate = std::max({std::abs(eye_.x), std::abs(eye_.y), std::abs(eye_.z)});
  const double ahead = std::max(glm::dot(pivot_ - eye_, forward_), 0x1p-4 * coordinate);
  camera.from = Vec3(eye_);
  camera.at = Vec3(eye_ + ahead * forward_);
  camera.up = Vec3(up_);
  camera.angle_degrees = angle_degrees_;
  return camera;
}

void OrbitCamera::orbit(Vec2 drag_pixels, PictureSize size) {
  const double per_pixel = std::numbers::pi / std::max(size.height, 1);
  const double elevation = std::asin(std::clamp(glm::dot(forward_, up_), -1.0, 1.0));
  const double limit = std::max(highest, std::abs(elevation));
  const double yaw = -per_pixel * drag_pixels.x;
  const double pitch = std::clamp(elevation - per_pixel * drag_pixels.y, -limit, limit) - elevation;
  const Vec3d right = glm::normalize(glm::cross(forward_, up_));
  const auto turned = [&](Vec3d v) { return rotated(rotated(v, right, pitch), up_, yaw); };
  eye_ = pivot_ + turned(eye_ - pivot_);
  forward_ = glm::normalize(turned(forward_));
  moved_ = true;
}

void OrbitCamera::pan(Vec2 from_pixel, Vec2 to_pixel, float depth, PictureSize size) {
  const double distance = depth_or_pivot(depth);
  const PrimaryRays rays(camera(), size.width, size.height);
  const Vec3d from = rays.ray(from_pixel.x, from_pixel.y).direction;
  const Vec3d to = rays.ray(to_pixel.x, to_pixel.y).direction;
  const Vec3d step = distance * (from - to);
  eye_ += step;
  pivot_ += step;
  moved_ = true;
}

void OrbitCamera::dolly(float notches, Vec2 pixel, float depth, PictureSize size) {
  const double distance = depth_or_pivot(depth);
  const double wanted = distance * std::pow(dolly_factor, static_cast<double>(notches));
  const double lowest = std::min(distance, nearest * scene_size_);
  const double greatest = std::max(distance, farthest * scene_size_);
  const double left = std::clamp(wanted, lowest, greatest);
  const PrimaryRays rays(camera(), size.width, size.height);
  eye_ += (distance - left) * Vec3d(rays.ray(pixel.x, pixel.y).direction);
  keep_pivot_in_front(left);
  moved_ = true;
}

void OrbitCamera::recentre(Vec3 point) {
  const Vec3d offset = Vec3d(point) - eye_;
  const double ahead = glm::dot(offset, forward_);
  eye_ += offset - ahead * forward_;
  pivot_ = point;
  keep_pivot_in_front(scene_size_);
  moved_ = true;
}

void OrbitCamera::frame(PictureSize size) {
  const float aspect =
      static_cast<float>(size.width) / static_cast<float>(std::max(size.height, 1));
  const Camera framed = frame_box(scene_box_, Vec3(forward_), Vec3(up_), aspect);
  eye_ = framed.from;
  pivot_ = framed.at;
  angle_degrees_ = framed.angle_degrees;
  moved_ = true;
}

double OrbitCamera::depth_or_pivot(float depth) const {
  if (is_usable(depth)) return depth;
  return glm::dot(pivot_ - eye_, forward_);
}

void OrbitCamera::keep_pivot_in_front(double depth) {
  constexpr double share = 0.05;  // of `depth`: closer, and a drag would swing the scene past
  const double ahead = glm::dot(pivot_ - eye_, forward_);
  if (!(ahead >= share * depth)) pivot_ = eye_ + depth * forward_;
}

}  // namespace bspview
