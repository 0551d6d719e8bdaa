// Sphereflake: every ball carries nine of a third of its size, three around its pole (the point
// away from its parent) and six around its equator.

#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

/// Where the nine balls sit on one whose pole is +z: three alike groups, a third of a turn apart.
std::array<Vec3d, 9> ball_directions() {
  std::array<Vec3d, 9> directions;
  for (int group = 0; group < 3; ++group) {
    const double turn = std::numbers::pi * (2.0 * group / 3.0);
    const auto direction = [&](double azimuth_degrees, double height) {
      const double azimuth = turn + std::numbers::pi * azimuth_degrees / 180.0;
      const double radius = std::sqrt(1.0 - height * height);
      return Vec3d(radius * std::cos(azimuth), radius * std::sin(azimuth), height);
    };
    directions[3 * group] = direction(45.0, std::sqrt(2.0 / 3.0));
    directions[3 * group + 1] = direction(15.0, 0.0);
    directions[3 * group + 2] = direction(75.0, 0.0);
  }
  return directions;
}

/// `v` turned as the shortest turn takes +z to the unit vector `pole`; half a turn is around y.
Vec3d turn_to(Vec3d pole, Vec3d v) {
  const double c = pole.z;
  if (c < -1.0 + 1e-9) return {-v.x, v.y, -v.z};
  const Vec3d axis(-pole.y, pole.x, 0.0);  // +z x pole: its length is the sine
  return c * v + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + c));
}

class Flake {
 public:
  Flake(Scene& scene, std::uint32_t material) : scene_(scene), material_(material) {}

  void add(int levels, Vec3d centre, double radius, Vec3d pole) {
    add_sphere(scene_, material_, {Vec3(centre), static_cast<float>(radius)});
    if (levels == 0) return;
    const double child = radius / 3.0;
    for (const Vec3d& direction : directions_) {
      const Vec3d turned = turn_to(pole, direction);
      add(levels - 1, centre + (radius + child) * turned, child, turned);
    }
  }

 private:
  Scene& scene_;
  std::uint32_t material_;
  std::array<Vec3d, 9> directions_ = ball_directions();
};

}  // namespace

double count_balls(int size) {
  return (std::pow(9.0, size + 1.0) - 1.0) / 8.0 + 1.0;
}

void make_balls(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {2.1f, 1.3f, 1.7f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 45.0f,
                  .hither = 0.01f};
  scene.lights = {{{4.0f, 3.0f, 2.0f}}, {{1.0f, -4.0f, 4.0f}}, {{-3.0f, 1.0f, 5.0f}}};
  const std::uint32_t ground =
      add_material(scene, {.color = {1.0f, 0.75f, 0.33f}, .diffuse = 0.8f, .shine = no_highlight});
  const std::uint32_t ball = add_material(
      scene, {.color = {1.0f, 0.9f, 0.7f}, .diffuse = 0.5f, .specular = 0.5f, .shine = 3.0827f});
  add_ground(scene, ground, 12.0f, -0.5f);
  Flake(scene, ball).add(size, Vec3d(0.0), 0.5, {0.0, 0.0, 1.0});
}

}  // namespace bspview
