#include "tests/support/scenes.h"

#include <array>
#include <cmath>

#include "tests/support/random.h"

namespace bspview::test {
namespace {

void add_lights_and_camera(Scene& scene, Vec3 centre) {
  scene.background = {0.1f, 0.2f, 0.3f};
  scene.lights = {{centre + Vec3(4, 5, 6), Vec3(1.0f)}, {centre + Vec3(-5, 3, 4), Vec3(0.8f)}};
  scene.camera = {centre + Vec3(2.5f, 2.0f, 3.0f), centre, {0, 1, 0}, 45.0f, 0.0f, 64, 64};
}

void add_materials(Scene& scene) {
  scene.materials = {{{0.9f, 0.5f, 0.2f}, 0.8f, 0.0f, 0.0f, 0.0f, 1.0f},
                     {{0.3f, 0.6f, 0.9f}, 0.5f, 0.4f, 20.0f, 0.0f, 1.0f},
                     {{0.8f, 0.9f, 0.8f}, 0.1f, 0.1f, 50.0f, 0.8f, 1.4f}};
}

/// A concave, planar star of 8 corners around `centre`.
void add_star(Scene& scene, Random& random, Vec3 centre, float size) {
  const Vec3 u = random.direction();
  const Vec3 v = glm::normalize(glm::cross(u, random.direction()));
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float angle = static_cast<float>(i) * 0.785398163f;
    const float radius = i % 2 == 0 ? size : 0.4f * size;
    corners[i] = centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }
  add_face(scene, static_cast<std::uint32_t>(random.below(3)), corners);
}

void add_triangle(Scene& scene, Random& random, Vec3 centre, float size) {
  const std::array<Vec3, 3> corners{centre + random.point(size), centre + random.point(size),
                                    centre + random.point(size)};
  const auto material = static_cast<std::uint32_t>(random.below(3));
  if (random.below(2) == 0) return add_face(scene, material, corners);
  const Vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const std::array<Vec3, 3> normals{glm::normalize(normal + 0.2f * random.direction()),
                                    glm::normalize(normal + 0.2f * random.direction()), normal};
  add_face(scene, material, corners, normals);
}

void add_random_object(Scene& scene, Random& random, Vec3 centre, float size) {
  const Vec3 place = centre + random.point(1.0f);
  const auto material = static_cast<std::uint32_t>(random.below(3));
  const float sign = random.below(5) == 0 ? -1.0f : 1.0f;
  switch (random.below(4)) {
    case 0:
      return add_triangle(scene, random, place, size);
    case 1:
      return add_star(scene, random, place, size);
    case 2:
      return add_sphere(scene, material, {place, sign * random.between(0.2f, 0.7f) * size});
    default:
      return add_cone(scene, material,
                      {place, sign * random.between(0.1f, 0.5f) * size, place + random.point(size),
                       sign * random.between(0.0f, 0.5f) * size});
  }
}

}  // namespace

Scene random_scene(int count, std::uint64_t seed, Vec3 centre) {
  Random random(seed);
  Scene scene;
  scene.name = "random";
  add_materials(scene);
  add_lights_and_camera(scene, centre);
  const float size = 0.9f / std::cbrt(static_cast<float>(count));
  for (int i = 0; i < count; ++i) add_random_object(scene, random, centre, size);
  return scene;
}

Scene random_triangles(int count, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.name = "triangles";
  add_materials(scene);
  add_lights_and_camera(scene, Vec3(0.0f));
  const float size = 0.9f / std::cbrt(static_cast<float>(count));
  for (int i = 0; i < count; ++i) add_triangle(scene, random, random.point(1.0f), size);
  return scene;
}

Scene cube_grid(int n, Vec3 centre) {
  Scene scene;
  scene.name = "cube grid";
  add_materials(scene);
  add_lights_and_camera(scene, centre);
  const auto place = [&](int i) { return -1.0f + 2.0f * static_cast<float>(i) / n; };
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](int i, int j) {
      Vec3 p(0.0f);
      p[axis] = side % 2 == 0 ? -1.0f : 1.0f;
      p[u] = place(i);
      p[v] = place(j);
      return centre + p;
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const Vec3 a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                   d = corner(i, j + 1);
        add_face(scene, 0, std::array{a, b, c});
        add_face(scene, 0, std::array{a, c, d});
      }
    }
  }
  return scene;
}

}  // namespace bspview::test
