// Balls at the points of a cubic lattice, joined by rods.

#include <cmath>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

// In units of the lattice's spacing.
constexpr double ball_radius = 0.25, rod_radius = 0.0625, rod_start = 0.12375;

struct LatticeMaterials {
  std::uint32_t ball = 0;
  std::uint32_t rod[3] = {};  // along x, y and z
};

LatticeMaterials add_materials(Scene& scene) {
  const auto rod = [&](Vec3 color) {
    return add_material(
        scene, {.color = color, .diffuse = 0.99f, .shine = no_highlight, .refraction_index = 0.0f});
  };
  LatticeMaterials materials;
  materials.ball = add_material(scene, {.color = Vec3(0.9f),
                                        .diffuse = 0.5f,
                                        .specular = 0.5f,
                                        .shine = 3.0827f,
                                        .refraction_index = 0.0f});
  materials.rod[0] = rod({0.9f, 0.1f, 0.1f});
  materials.rod[1] = rod({0.1f, 0.9f, 0.1f});
  materials.rod[2] = rod({0.1f, 0.1f, 0.9f});
  return materials;
}

/// The ball at lattice point `p` and the rods from it to the next points along the axes.
void add_lattice_point(Scene& scene, const LatticeMaterials& materials, glm::ivec3 p, int size) {
  const auto position = [&](Vec3d offset) { return Vec3((Vec3d(p) + offset) / double(size)); };
  add_sphere(scene, materials.ball, {position(Vec3d(0.0)), float(ball_radius / size)});
  const float radius = float(rod_radius / size);
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] == size) continue;
    Vec3d start(0.0), end(0.0);
    start[axis] = rod_start;
    end[axis] = 1.0 - rod_start;
    add_cone(scene, materials.rod[axis], {position(start), radius, position(end), radius});
  }
}

}  // namespace

double count_lattice(int size) {
  const double points = size + 1.0;
  return points * points * points + 3.0 * points * points * size;
}

void make_lattice(Scene& scene, int size) {
  const double half_cell = 0.5 / size;
  const double middle_cell = (size / 2 + 0.5) / size;
  scene.background = spd_sky;
  scene.camera = {.from = {middle_cell, 1.0, 1.0 - half_cell},
                  .at = {middle_cell, -1.0, -1.0 - half_cell},
                  .up = {0.2f, 1.0f, 0.0f},
                  .angle_degrees = 60.0f,
                  .hither = 0.0f};
  scene.lights = {{{2.0f, 0.5f, 0.5f}},  {{-1.0f, 0.5f, 0.5f}}, {{0.5f, 2.0f, 0.5f}},
                  {{0.5f, -1.0f, 0.5f}}, {{0.5f, 0.5f, 2.0f}},  {{0.5f, 0.5f, -1.0f}}};
  const LatticeMaterials materials = add_materials(scene);
  for (int x = 0; x <= size; ++x) {
    for (int y = 0; y <= size; ++y) {
      for (int z = 0; z <= size; ++z) add_lattice_point(scene, materials, {x, y, z}, size);
    }
  }
}

}  // namespace bspview
