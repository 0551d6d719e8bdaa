// Pyramid of objects, each of six interlocked pentagonal rings around the axes of an icosahedron.

#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr double tube_radius = 0.07412;
constexpr double ring_radius = 1.0 / (1.0 + tube_radius);
constexpr double spacing = 2.0;  // of the objects in a layer

/// From layer to layer: the pyramid opens with the view's 45 degrees.
const double layer_distance = 1.0 / std::sin(std::numbers::pi / 8.0);

using Ring = std::array<Vec3d, 5>;

std::array<Ring, 6> make_ring_set() {
  const double cos_tilt = 1.0 / std::sqrt(5.0), sin_tilt = 2.0 / std::sqrt(5.0);
  std::array<Ring, 6> rings;
  for (int ring = 0; ring < 6; ++ring) {
    const bool flat = ring == 0;
    const double azimuth = flat ? 0.0 : std::numbers::pi * (72.0 * ring - 36.0) / 180.0;
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    for (int corner = 0; corner < 5; ++corner) {
      const double angle = 2.0 * std::numbers::pi * corner / 5.0;
      const double x = ring_radius * std::cos(angle), side = ring_radius * std::sin(angle);
      const double y = flat ? side : side * cos_tilt, z = flat ? 0.0 : side * sin_tilt;
      rings[ring][corner] = {c * x - s * y, s * x + c * y, z};
    }
  }
  return rings;
}

/// Six garish colours.
std::array<std::uint32_t, 6> add_ring_materials(Scene& scene) {
  constexpr Vec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}};
  std::array<std::uint32_t, 6> materials;
  for (int ring = 0; ring < 6; ++ring) {
    materials[ring] = add_material(scene, {.color = colors[ring],
                                           .diffuse = 0.5f,
                                           .specular = 0.2f,
                                           .shine = 3.0827f,
                                           .refraction_index = 0.0f});
  }
  return materials;
}

void add_ring(Scene& scene, std::uint32_t material, const Ring& ring, Vec3d centre) {
  const float radius = float(tube_radius);
  for (int corner = 0; corner < 5; ++corner) {
    const Vec3 here(centre + ring[corner]), previous(centre + ring[(corner + 4) % 5]);
    add_cone(scene, material, {here, radius, previous, radius});
    add_sphere(scene, material, {here, radius});
  }
}

/// Behind the pyramid; as large as the view there, and one per cent.
void add_backdrop(Scene& scene, int size) {
  const std::uint32_t white =
      add_material(scene, {.color = Vec3(1.0f), .shine = no_highlight, .refraction_index = 0.0f});
  const Vec3d eye(scene.camera.from);
  const double half = 1.01 * (size + 2) * layer_distance * std::tan(std::numbers::pi / 8.0);
  const double y = (size + 1) * layer_distance;
  const double right = eye.x + half, left = eye.x - half, top = eye.z + half, bottom = eye.z - half;
  add_face(scene, white,
           std::array{Vec3(right, y, top), Vec3(left, y, top), Vec3(left, y, bottom),
                      Vec3(right, y, bottom)});
}

}  // namespace

double count_rings(int size) {
  const double n = size;
  return 10.0 * n * (n + 1.0) * (2.0 * n + 1.0) + 1.0;  // 60 primitives in each of 1 + 4 + ... n^2
}

void make_rings(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {-1.0, -layer_distance, 0.5},
                  .at = {-1.0, 1.0 - layer_distance, 0.5},
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 45.0f,
                  .hither = 1.0f};
  scene.lights = {{{3.0, -layer_distance, 3.0}},
                  {{-4.0, -layer_distance, 1.0}},
                  {{2.0, -layer_distance, -4.0}}};
  add_backdrop(scene, size);
  const std::array<Ring, 6> rings = make_ring_set();
  const std::array<std::uint32_t, 6> materials = add_ring_materials(scene);
  for (int layer = 1; layer <= size; ++layer) {
    for (int object = 0; object < layer * layer; ++object) {
      const Vec3d centre(spacing * (object % layer) - (layer - 1), layer * layer_distance,
                         spacing * (object / layer) - (layer - 1));
      for (int ring = 0; ring < 6; ++ring) add_ring(scene, materials[ring], rings[ring], centre);
    }
  }
}

}  // namespace bspview
