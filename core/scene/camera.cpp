#include "core/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bspview {
namespace {

constexpr double narrowest_angle = 1e-4, widest_angle = 179.0;  // degrees

bool is_finite(Vec3d v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Vec3d finite_or(Vec3 v, Vec3d otherwise) {
  return is_finite(v) ? Vec3d(v) : otherwise;
}

/// Unit vector along `v`; `otherwise` when `v` has no direction.
Vec3d unit_or(Vec3d v, Vec3d otherwise) {
  const double length = glm::length(v);
  return std::isfinite(length) && length > 0.0 ? v / length : otherwise;
}

/// Right-handed axes of the picture.
struct ViewAxes {
  Vec3d forward, right, down;
};

ViewAxes make_axes(Vec3d view, Vec3d up) {
  // Below this sine of the angle between view and up, up says nothing about the picture's roll.
  constexpr double parallel = 1e-7;
  const Vec3d forward = unit_or(view, {0.0, 0.0, -1.0});
  const Vec3d side = glm::cross(forward, unit_or(up, {0.0, 1.0, 0.0}));
  if (glm::length(side) > parallel) {
    const Vec3d right = glm::normalize(side);
    return {forward, right, glm::cross(forward, right)};
  }
  const Vec3d other_up = std::abs(forward.y) < 0.9 ? Vec3d(0.0, 1.0, 0.0) : Vec3d(0.0, 0.0, 1.0);
  const Vec3d right = glm::normalize(glm::cross(forward, other_up));
  return {forward, right, glm::cross(forward, right)};
}

/// Side of a square pixel at distance 1: the angle spans height - 1 of them.
double pixel_size(const Camera& camera, int height) {
  const double degrees = std::isfinite(camera.angle_degrees) ? camera.angle_degrees : 45.0;
  const double angle = std::clamp(degrees, narrowest_angle, widest_angle);
  return 2.0 * std::tan(angle * std::numbers::pi / 360.0) / std::max(height - 1, 1);
}

struct BoxToFrame {
  Vec3d centre, half_extent;
};

/// A box to look at, also where `box` is empty, a point, or not finite.
BoxToFrame visible_box(const Aabb& box) {
  if (box.empty() || !is_finite(box.lo) || !is_finite(box.hi)) return {Vec3d(0.0), Vec3d(1.0)};
  const Vec3d lo(box.lo), hi(box.hi);
  const Vec3d centre = 0.5 * (lo + hi);
  Vec3d half = 0.5 * (hi - lo);
  // Smaller than this around the centre, floats could no longer tell the eye from the target.
  const double coordinate = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
  const double smallest = std::max(coordinate * 0x1p-16, 1e-30);
  if (std::max({half.x, half.y, half.z}) < smallest) half = Vec3d(smallest);
  return {centre, half};
}

/// Corner `i` of 8, seen from the centre.
Vec3d corner_of(Vec3d half_extent, int i) {
  return half_extent * Vec3d(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
}

}  // namespace

Camera frame_box(const Aabb& box, Vec3 direction, Vec3 up, float aspect) {
  constexpr double margin = 1.05;  // of the picture's half width, around the box
  Camera camera;
  const double shape = std::isfinite(aspect) ? std::clamp<double>(aspect, 1e-3, 1e3) : 1.0;
  camera.width = std::max(1, static_cast<int>(std::lround(camera.height * shape)));

  const auto [centre, half_extent] = visible_box(box);
  const ViewAxes axes = make_axes(direction, up);
  const double pixel = pixel_size(camera, camera.height);
  const Vec3d half_picture = 0.5 * pixel * Vec3d(camera.width, camera.height, 0.0) / margin;

  // The distance from which every corner of the box is inside the picture.
  double distance = 0.0;
  for (int i = 0; i < 8; ++i) {
    const Vec3d corner = corner_of(half_extent, i);
    const double x = std::abs(glm::dot(corner, axes.right)) / half_picture.x;
    const double y = std::abs(glm::dot(corner, axes.down)) / half_picture.y;
    distance = std::max(distance, std::max(x, y) - glm::dot(corner, axes.forward));
  }
  camera.at = Vec3(centre);
  camera.from = Vec3(centre - distance * axes.forward);
  camera.up = Vec3(-axes.down);
  return camera;
}

PrimaryRays::PrimaryRays(const Camera& camera, int width, int height)
    : pixel_(pixel_size(camera, height)),
      half_width_(0.5 * std::max(width, 1)),
      half_height_(0.5 * std::max(height, 1)) {
  const Vec3d from = finite_or(camera.from, Vec3d(0.0));
  const Vec3d at = finite_or(camera.at, from);
  const ViewAxes axes = make_axes(at - from, camera.up);
  forward_axis_ = axes.forward;
  right_axis_ = axes.right;
  down_axis_ = axes.down;
  from_ = Vec3(from);
  right_ = Vec3(pixel_ * axes.right);
  down_ = Vec3(pixel_ * axes.down);
  corner_ = Vec3(axes.forward - pixel_ * (half_width_ * axes.right + half_height_ * axes.down));
}

Vec3 PrimaryRays::project(Vec3 point) const {
  const Vec3d offset = Vec3d(point) - Vec3d(from_);
  const double depth = glm::dot(offset, forward_axis_);
  const double scale = 1.0 / (pixel_ * depth);
  return Vec3(half_width_ + scale * glm::dot(offset, right_axis_),
              half_height_ + scale * glm::dot(offset, down_axis_), depth);
}

}  // namespace bspview
