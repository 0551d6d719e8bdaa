// The SPD's example of its library: three tori of triangles through a cone on a disc.

#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr int torus_steps = 12;  // around the axis, and around the tube
constexpr double torus_radius = 2.0, tube_radius = 0.5;

constexpr int disc_steps = 16;
constexpr double disc_radius = 4.0, disc_height = -2.0;

struct Torus {
  Vec3d centre, axis, start;  // `start` points from the centre to the first vertices
  Vec3 color;
};

const std::array<Torus, 3> tori{
    Torus{{-1, 0, 0}, Vec3d(2, 2, -1) / 3.0, Vec3d(1, -2, -2) / 3.0, {0.0f, 1.0f, 1.0f}},
    Torus{{0, 0, 0}, Vec3d(0, 2, -1) / std::sqrt(5.0), {1, 0, 0}, {1.0f, 1.0f, 0.0f}},
    Torus{{1, 0, 0}, Vec3d(-2, 2, -1) / 3.0, Vec3d(1, 2, 2) / 3.0, {1.0f, 0.0f, 1.0f}}};

std::uint32_t add_color(Scene& scene, Vec3 color) {
  return add_material(scene, {.color = color, .diffuse = 0.7f, .shine = 45.2776f});
}

struct SurfacePoint {
  Vec3 position, normal;
};

/// The point `along` steps around the torus and `around` steps around its tube, from the axis
/// outwards.
SurfacePoint torus_point(const Torus& torus, int along, int around) {
  const double step = 2.0 * std::numbers::pi / torus_steps;
  const double phi = along * step, theta = around * step;
  const Vec3d outward =
      std::cos(phi) * torus.start + std::sin(phi) * glm::cross(torus.axis, torus.start);
  const Vec3d normal = std::cos(theta) * torus.axis + std::sin(theta) * outward;
  return {Vec3(torus.centre + torus_radius * outward + tube_radius * normal), Vec3(normal)};
}

void add_patch(Scene& scene, std::uint32_t material, const std::array<SurfacePoint, 3>& points) {
  add_face(scene, material, std::array{points[0].position, points[1].position, points[2].position},
           std::array{points[0].normal, points[1].normal, points[2].normal});
}

void add_torus(Scene& scene, const Torus& torus) {
  const std::uint32_t material = add_color(scene, torus.color);
  for (int around = 0; around < torus_steps; ++around) {
    for (int along = 0; along < torus_steps; ++along) {
      const SurfacePoint a = torus_point(torus, along, around);
      const SurfacePoint b = torus_point(torus, along + 1, around);
      const SurfacePoint c = torus_point(torus, along + 1, around + 1);
      const SurfacePoint d = torus_point(torus, along, around + 1);
      add_patch(scene, material, {c, b, a});
      add_patch(scene, material, {d, c, a});
    }
  }
}

void add_disc(Scene& scene, std::uint32_t material) {
  const auto rim = [](int i) {
    const double angle = 2.0 * std::numbers::pi * i / disc_steps;
    return Vec3(disc_radius * std::cos(angle), disc_height, -disc_radius * std::sin(angle));
  };
  for (int i = 0; i < disc_steps; ++i) {
    add_face(scene, material, std::array{rim(i), rim(i + 1), Vec3(0.0, disc_height, 0.0)});
  }
}

}  // namespace

double count_sample(int) {
  return tori.size() * 2.0 * torus_steps * torus_steps + 1.0 + disc_steps;
}

void make_sample(Scene& scene, int) {
  scene.background = Vec3(0.8f);
  scene.camera = {.from = {0.0f, 5.0f, -5.0f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 1.0f, 0.0f},
                  .angle_degrees = 45.0f,
                  .hither = 0.001f};
  scene.lights = {{{-10.0f, 20.0f, -20.0f}}};
  for (const Torus& torus : tori) add_torus(scene, torus);
  const std::uint32_t red = add_color(scene, {1.0f, 0.0f, 0.0f});
  add_cone(scene, red, {{0.0f, -2.0f, 0.0f}, 2.0f, {0.0f, 2.0f, 0.0f}, 0.1f});
  add_disc(scene, red);
}

}  // namespace bspview
