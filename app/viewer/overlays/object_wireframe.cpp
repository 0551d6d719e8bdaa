#include "app/viewer/overlays/object_wireframe.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace bspview {
namespace {

constexpr int circle_segments = 32;

/// Radius vectors to the right and upwards.
struct Circle {
  Vec3 centre, right, up;

  Vec3 at(int segment) const {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(segment) /
                        static_cast<float>(circle_segments);
    return centre + std::cos(angle) * right + std::sin(angle) * up;
  }
};

void add_line(LineList& lines, Line pen, Vec3 from, Vec3 to) {
  pen.from = from;
  pen.to = to;
  lines.push_back(pen);
}

void add_circle(LineList& lines, const Line& pen, const Circle& circle) {
  for (int i = 0; i < circle_segments; ++i) {
    add_line(lines, pen, circle.at(i), circle.at(i + 1));
  }
}

void add_face(LineList& lines, const Line& pen, std::span<const Vec3> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    add_line(lines, pen, vertices[i], vertices[(i + 1) % vertices.size()]);
  }
}

void add_sphere(LineList& lines, const Line& pen, const Sphere& sphere) {
  const float radius = sphere.radius;
  const std::array axes{Vec3(radius, 0.0f, 0.0f), Vec3(0.0f, radius, 0.0f),
                        Vec3(0.0f, 0.0f, radius)};
  for (int i = 0; i < 3; ++i) {
    add_circle(lines, pen, {sphere.centre, axes[i], axes[(i + 1) % 3]});
  }
}

void add_cone(LineList& lines, const Line& pen, const Cone& cone) {
  const Vec3 axis = cone.apex - cone.base;
  const Vec3 size = magnitudes(axis);
  // Any direction that is not the axis' own: along its least component.
  const Vec3 other(size.x <= size.y && size.x <= size.z, size.y < size.x && size.y <= size.z,
                   size.z < size.x && size.z < size.y);
  const Vec3 right = glm::normalize(glm::cross(axis, other));
  const Vec3 up = glm::normalize(glm::cross(axis, right));
  const Circle base{cone.base, cone.base_radius * right, cone.base_radius * up};
  const Circle apex{cone.apex, cone.apex_radius * right, cone.apex_radius * up};
  add_circle(lines, pen, base);
  if (cone.apex_radius != 0.0f) add_circle(lines, pen, apex);
  for (int i = 0; i < circle_segments; i += circle_segments / 4) {
    add_line(lines, pen, base.at(i), apex.at(i));
  }
}

}  // namespace

void add_wireframe(LineList& lines, const Scene& scene, std::uint32_t object, Line pen) {
  if (object >= scene.objects.size() || is_degenerate(scene, object)) return;
  const std::uint32_t shape = scene.objects[object].shape;
  switch (scene.objects[object].kind) {
    case ObjectKind::triangle:
    case ObjectKind::polygon:
      return add_face(lines, pen, vertices_of(scene, scene.faces[shape]));
    case ObjectKind::sphere:
      return add_sphere(lines, pen, scene.spheres[shape]);
    case ObjectKind::cone:
      return add_cone(lines, pen, scene.cones[shape]);
  }
}

}  // namespace bspview
