// Recursive tetrahedral pyramid, first pictured by Mandelbrot and Norton.
// A tetrahedron is every second corner of a cube; its four halves sit at these corners.

#include <array>
#include <cmath>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr std::array<Vec3d, 4> corners{Vec3d{-1, -1, 1}, Vec3d{-1, 1, -1}, Vec3d{1, -1, -1},
                                       Vec3d{1, 1, 1}};

void add_tetrahedron(Scene& scene, std::uint32_t material, Vec3d centre, double half) {
  constexpr int faces[4][3] = {{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}};
  for (const auto& face : faces) {
    std::array<Vec3, 3> vertices;
    for (int i = 0; i < 3; ++i) vertices[i] = Vec3(centre + half * corners[face[i]]);
    add_face(scene, material, vertices);
  }
}

void add_pyramid(Scene& scene, int levels, Vec3d centre, double half) {
  if (levels == 1) return add_tetrahedron(scene, 0, centre, half);
  for (const Vec3d& corner : corners) {
    add_pyramid(scene, levels - 1, centre + 0.5 * half * corner, 0.5 * half);
  }
}

}  // namespace

double count_tetra(int size) {
  return std::pow(4.0, size);
}

void make_tetra(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {1.02285f, -3.17715f, -2.17451f},
                  .at = {-0.004103f, -0.004103f, 0.216539f},
                  .up = {-0.816497f, -0.816497f, 0.816497f},
                  .angle_degrees = 45.0f,
                  .hither = 1.0f};
  scene.lights = {{{2.0f, -18.0f, -5.0f}}};
  add_material(scene, {.color = {1.0f, 0.2f, 0.2f}, .shine = no_highlight, .refraction_index = 0});
  add_pyramid(scene, size, Vec3d(0.0), 1.0);
}

}  // namespace bspview
