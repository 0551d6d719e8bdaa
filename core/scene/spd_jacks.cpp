// Fractal of jacks (three crossed rods with balls at their ends): every jack carries eight of half
// its size, one in each octant between its rods.

#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr double arm = 0.75;         // half the length of a rod of the first jack
constexpr double rod_radius = 0.1;   // of the arm
constexpr double ball_radius = 0.2;  // of the arm

/// The directions of the rods: the axes turned by 20 degrees around y, then -30 around x.
std::array<Vec3d, 3> rod_directions() {
  const double c = std::cos(std::numbers::pi / 9.0), s = std::sin(std::numbers::pi / 9.0);
  const double tilt_c = std::sqrt(3.0) / 2.0, tilt_s = 0.5;
  return {Vec3d{c, s * tilt_s, s * tilt_c}, Vec3d{0.0, tilt_c, -tilt_s},
          Vec3d{-s, c * tilt_s, c * tilt_c}};
}

void add_jack(Scene& scene, Vec3d centre, const std::array<Vec3d, 3>& rods, double length) {
  const float rod = float(rod_radius * length), ball = float(ball_radius * length);
  for (const Vec3d& direction : rods) {
    const Vec3d half = length * direction;
    add_cone(scene, 0, {Vec3(centre - half), rod, Vec3(centre + half), rod});
  }
  for (const double sign : {1.0, -1.0}) {
    for (const Vec3d& direction : rods) {
      add_sphere(scene, 0, {Vec3(centre + sign * length * direction), ball});
    }
  }
}

void add_jacks(Scene& scene, int levels, Vec3d centre, double length) {
  static const std::array<Vec3d, 3> rods = rod_directions();
  add_jack(scene, centre, rods, length);
  if (levels == 1) return;
  for (int octant = 0; octant < 8; ++octant) {
    Vec3d offset(0.0);
    for (int rod = 0; rod < 3; ++rod)
      offset += ((octant >> (2 - rod)) & 1 ? 1.0 : -1.0) * rods[rod];
    add_jacks(scene, levels - 1, centre + 2.0 / 3.0 * length * offset, 0.5 * length);
  }
}

}  // namespace

double count_jacks(int size) {
  return 9.0 * (std::pow(8.0, size) - 1.0) / 7.0;
}

void make_jacks(Scene& scene, int size) {
  scene.background = {0.2f, 0.05f, 0.2f};
  scene.camera = {.from = {0.0f, 0.0f, -8.0f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 1.0f, 0.0f},
                  .angle_degrees = 25.0f,
                  .hither = 0.001f,
                  .width = 256,
                  .height = 256};
  scene.lights = {{{-10.0f, 3.0f, -20.0f}}};
  add_material(
      scene,
      {.color = {0.737f, 0.561f, 0.561f}, .diffuse = 0.7f, .specular = 0.7f, .shine = 11.1434f});
  add_jacks(scene, size, Vec3d(0.0), arm);
}

}  // namespace bspview
