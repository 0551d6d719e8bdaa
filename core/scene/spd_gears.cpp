// Cube of meshing gears, every fifth or so of glass, above a mirror.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr int teeth = 36;
constexpr int rim_vertices = 4 * teeth;
constexpr double tooth_degrees = 360.0 / teeth;

// In units of 1 / (19 size + 1), which makes the teeth of the outermost gears almost touch x = +-1.
constexpr double pitch_radius = 19.0, root_radius = 18.0, tip_radius = 19.9;
constexpr double tip_half_degrees = 1.9, root_half_degrees = 2.0;

/// Thin enough that layers, which lie 1 / size apart, stay apart.
double thickness(int size) {
  return std::min(0.1, 0.5 / size);
}

using Rim = std::array<Vec3d, rim_vertices>;

/// Outline around the origin, counter-clockwise. Gears of parity 0 and 1 alternate: the teeth of
/// one point where its neighbours have gaps.
Rim make_rim(int parity, double unit) {
  const auto point = [&](double radius, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return unit * radius * Vec3d(std::cos(angle), std::sin(angle), 0.0);
  };
  Rim rim;
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const double tip = tooth_degrees * (tooth + 0.5 * parity);
    const double root = tip + 0.5 * tooth_degrees;
    rim[4 * tooth] = point(tip_radius, tip - tip_half_degrees);
    rim[4 * tooth + 1] = point(tip_radius, tip + tip_half_degrees);
    rim[4 * tooth + 2] = point(root_radius, root - root_half_degrees);
    rim[4 * tooth + 3] = point(root_radius, root + root_half_degrees);
  }
  return rim;
}

/// Colour and kind of the gear in column `x`, row `y` and, from the top, layer `z`.
Material gear_material(int x, int y, int z) {
  const Vec3d color = 0.07 + Vec3d((x + 3 * y + 5 * z + 5) % 7, (3 * x + 2 * y + 6 * z + 3) % 7,
                                   (4 * x + 2 * y + 6 * z + 2) % 7);
  Material material{.color = Vec3(color / std::max({color.x, color.y, color.z})),
                    .shine = no_highlight,
                    .refraction_index = 0.0f};
  if ((x + 3 * y + 4 * z) % 5 != 0) return material;
  material.diffuse = 0.2f;
  material.transmittance = 0.8f;
  material.refraction_index = 1.1f;
  return material;
}

struct Placement {
  Vec3d centre;  // of the top face
  double depth;
};

void add_gear(Scene& scene, std::uint32_t material, const Rim& rim, const Placement& gear) {
  std::array<Vec3, rim_vertices> top, bottom;
  for (int i = 0; i < rim_vertices; ++i) {
    top[i] = Vec3(gear.centre + rim[i]);
    bottom[i] = Vec3(gear.centre + rim[i] - Vec3d(0.0, 0.0, gear.depth));
  }
  add_face(scene, material, top);
  for (int i = 0; i < rim_vertices; ++i) {
    const int next = (i + 1) % rim_vertices;
    add_face(scene, material, std::array{top[i], bottom[i], bottom[next], top[next]});
  }
  std::reverse(bottom.begin(), bottom.end());
  std::rotate(bottom.begin(), bottom.end() - 2, bottom.end());  // starts with a tooth's tip
  add_face(scene, material, bottom);
}

void add_gears(Scene& scene, int size) {
  const double unit = 1.0 / (pitch_radius * size + 1.0);
  const std::array<Rim, 2> rims{make_rim(0, unit), make_rim(1, unit)};
  const auto position = [&](int i) { return (2 * i + 1 - size) * pitch_radius * unit; };
  for (int z = 0; z < size; ++z) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const std::uint32_t material = add_material(scene, gear_material(x, y, z));
        const Vec3d centre(position(x), position(y), 1.0 - double(z) / size);
        add_gear(scene, material, rims[(x + y + z) % 2], {centre, thickness(size)});
      }
    }
  }
}

}  // namespace

double count_gears(int size) {
  return (rim_vertices + 2.0) * std::pow(size, 3.0) + 1.0;
}

void make_gears(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {-1.1f, -2.1f, 2.6f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 45.0f,
                  .hither = 1.0f};
  scene.lights = {{{2.0f, 4.0f, 4.0f}},
                  {{-2.0f, 4.0f, 3.0f}},
                  {{2.0f, -2.5f, 2.5f}},
                  {{-1.0f, -4.0f, 2.0f}},
                  {{-1.111f, -2.121f, 2.626f}}};
  const std::uint32_t mirror = add_material(scene, {.color = {1.0f, 0.85f, 0.7f},
                                                    .diffuse = 0.3f,
                                                    .specular = 0.6f,
                                                    .shine = 3.0827f,
                                                    .refraction_index = 0.0f});
  add_ground(scene, mirror, 2.0f, 0.0f);
  add_gears(scene, size);
}

}  // namespace bspview
