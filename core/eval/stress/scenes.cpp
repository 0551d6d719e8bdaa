#include "core/eval/stress/scenes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace bspview::stress {
namespace {

void add_triangle(Scene& scene, Vec3 place, float size, Dice& dice) {
  const Vec3 a = place + dice.point(size), b = place + dice.point(size);
  add_face(scene, 0, std::array{a, b, place + dice.point(size)});
}

void add_star(Scene& scene, Vec3 place, float size, Dice& dice) {
  const Vec3 u = dice.direction();
  const Vec3 v = glm::normalize(glm::cross(u, dice.direction()));
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float angle = 0.25f * std::numbers::pi_v<float> * static_cast<float>(i);
    const float radius = i % 2 == 0 ? size : 0.4f * size;
    corners[i] = place + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }
  add_face(scene, 0, corners);
}

void add_random_cone(Scene& scene, Vec3 place, float size, Dice& dice) {
  const float sign = dice.one_in(4) ? -1.0f : 1.0f;
  const float base = dice.between(0.1f, 0.6f) * size;
  const float tip = dice.one_in(3) ? 0.0f : dice.one_in(2) ? base : dice.between(0.1f, 0.6f) * size;
  const Vec3 axis = dice.between(0.5f, 1.5f) * size * dice.direction();
  add_cone(scene, 0, {place, sign * base, place + axis, sign * tip});
}

Scene scene_of_kinds(std::span<const ObjectKind> kinds, int count, Vec3 centre, Dice& dice) {
  Scene scene;
  scene.name = "mixed scene";
  const float size = 0.9f / std::cbrt(static_cast<float>(count));
  for (int i = 0; i < count; ++i) {
    const Vec3 place = centre + dice.point(1.0f);
    add_random(scene, kinds[static_cast<std::size_t>(i) % kinds.size()], place, size, dice);
  }
  return scene;
}

}  // namespace

void add_random(Scene& scene, ObjectKind kind, Vec3 place, float size, Dice& dice) {
  if (scene.materials.empty()) scene.materials.resize(1);
  switch (kind) {
    case ObjectKind::triangle:
      return add_triangle(scene, place, size, dice);
    case ObjectKind::polygon:
      return add_star(scene, place, size, dice);
    case ObjectKind::sphere:
      return add_sphere(scene, 0,
                        {place, (dice.one_in(4) ? -1.0f : 1.0f) * dice.between(0.2f, 0.8f) * size});
    case ObjectKind::cone:
      return add_random_cone(scene, place, size, dice);
  }
}

Scene make_mixed_scene(int count, Vec3 centre, Dice& dice) {
  constexpr std::array kinds{ObjectKind::triangle, ObjectKind::polygon, ObjectKind::sphere,
                             ObjectKind::cone};
  return scene_of_kinds(kinds, count, centre, dice);
}

Scene make_scene_without_polygons(int count, Vec3 centre, Dice& dice) {
  constexpr std::array kinds{ObjectKind::triangle, ObjectKind::sphere, ObjectKind::cone};
  return scene_of_kinds(kinds, count, centre, dice);
}

Scene make_coplanar_scene(int count, int axis, float position, Dice& dice) {
  Scene scene;
  scene.name = "coplanar scene";
  scene.materials.resize(1);
  const auto at = [&](float u, float v) {
    Vec3 point;
    point[axis] = position;
    point[(axis + 1) % 3] = u;
    point[(axis + 2) % 3] = v;
    return point;
  };
  const auto add_square = [&](float u, float v, float side) {
    add_face(scene, 0,
             std::array{at(u, v), at(u + side, v), at(u + side, v + side), at(u, v + side)});
  };
  for (int i = 1; i < count; ++i) {
    const float u = dice.between(-1.0f, 0.9f), v = dice.between(-1.0f, 0.9f);
    if (dice.one_in(2)) {
      add_square(u, v, 0.1f);
    } else {
      add_face(scene, 0, std::array{at(u, v), at(u + 0.1f, v), at(u, v + 0.1f)});
    }
  }
  add_square(-1.0f, -1.0f, 2.0f);
  return scene;
}

std::string describe_object(const Scene& scene, std::uint32_t id) {
  const auto [kind, shape, material] = scene.objects[id];
  const auto point = [](Vec3 p) { return fmt::format("{:a} {:a} {:a}", p.x, p.y, p.z); };
  if (kind == ObjectKind::sphere) {
    const auto& [centre, radius] = scene.spheres[shape];
    return fmt::format("sphere {} radius {:a}", point(centre), radius);
  }
  if (kind == ObjectKind::cone) {
    const Cone& cone = scene.cones[shape];
    return fmt::format("cone {} radius {:a} to {} radius {:a}", point(cone.base), cone.base_radius,
                       point(cone.apex), cone.apex_radius);
  }
  std::string text = kind == ObjectKind::triangle ? "triangle" : "polygon";
  for (const Vec3 p : vertices_of(scene, scene.faces[shape]))
    text += fmt::format(" ({})", point(p));
  return text;
}

}  // namespace bspview::stress
