// Seashell of overlapping spheres on a logarithmic spiral, after Pickover, IEEE CG&A 9(6), 1989.

#include <cmath>
#include <numbers>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr double first_turn = -6.0, last_turn = 3.0;
constexpr double growth = 0.15;  // of the radius, e-fold a radian

int steps(int size) {
  return 180 << size;
}

}  // namespace

double count_shells(int size) {
  return 180.0 * std::pow(2.0, size) + 1.0;
}

void make_shells(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {-6.0f, -60.0f, 35.0f},
                  .at = {0.0f, 8.0f, -15.0f},
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 45.0f,
                  .hither = 0.5f};
  scene.lights = {{{-100.0f, -100.0f, 100.0f}}};
  const std::uint32_t material = add_material(
      scene, {.color = {1.0f, 0.8f, 0.4f}, .diffuse = 0.8f, .specular = 0.2f, .shine = 45.2776f});
  const int n = steps(size);
  for (int i = 0; i <= n; ++i) {
    const double turn = first_turn + (last_turn - first_turn) * i / n;
    const double angle = 2.0 * std::numbers::pi * turn;
    const double radius = std::exp(growth * angle);
    const Vec3d centre(radius * std::sin(angle), radius * std::cos(angle), -2.0 * radius);
    add_sphere(scene, material, {Vec3(centre), static_cast<float>(radius)});
  }
}

}  // namespace bspview
