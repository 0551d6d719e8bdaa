// Tree after Aono & Kunii, "Botanical tree image generation", IEEE CG&A 4(5), 1984:
// every branch forks into two, thinner and shorter.

#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr double trunk_radius = 0.15, trunk_length = 1.0;
constexpr double taper = 0.67;  // radius at a branch's end to that at its start

struct Fork {
  double tilt_degrees, azimuth_degrees;  // away from the parent; around it
  double length;                         // to the parent's
};
constexpr std::array<Fork, 2> forks{Fork{40.0, 0.0, 0.65}, Fork{25.0, 140.0, 0.7}};

/// Local axes of a branch, which grows along z.
struct Frame {
  Vec3d x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

  Vec3d to_world(Vec3d v) const { return v.x * x + v.y * y + v.z * z; }
};

/// Axes of a branch that forks off the one with axes `parent`: the next fork's plane is at a right
/// angle to this one's.
Frame fork_frame(const Frame& parent, const Fork& fork) {
  const double tilt = fork.tilt_degrees * std::numbers::pi / 180.0;
  const double azimuth = fork.azimuth_degrees * std::numbers::pi / 180.0;
  const Vec3d outward(std::cos(azimuth), std::sin(azimuth), 0.0);
  const Vec3d sideways(-outward.y, outward.x, 0.0);
  const Vec3d up(0.0, 0.0, 1.0);
  const Vec3d across = std::cos(tilt) * outward - std::sin(tilt) * up;
  return {parent.to_world(sideways), parent.to_world(-across),
          parent.to_world(std::sin(tilt) * outward + std::cos(tilt) * up)};
}

struct Branch {
  Vec3d base{0.0};
  double radius = trunk_radius;
  double length = trunk_length;
  Frame frame;
};

void add_branches(Scene& scene, std::uint32_t material, int levels, const Branch& branch) {
  const Vec3d end = branch.base + branch.length * branch.frame.z;
  const double end_radius = taper * branch.radius;
  add_cone(scene, material,
           {Vec3(branch.base), float(branch.radius), Vec3(end), float(end_radius)});
  add_sphere(scene, material, {Vec3(end), float(end_radius)});
  if (levels == 0) return;
  for (const Fork& fork : forks) {
    add_branches(scene, material, levels - 1,
                 {end, end_radius, fork.length * branch.length, fork_frame(branch.frame, fork)});
  }
}

}  // namespace

double count_tree(int size) {
  return 2.0 * (std::pow(2.0, size + 1.0) - 1.0) + 1.0;
}

void make_tree(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {4.5f, 0.4f, 2.0f},
                  .at = {0.0f, 0.0f, 1.5f},
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 45.0f,
                  .hither = 1.0f};
  scene.lights = {{{-5.0f, 5.0f, 50.0f}},   {{30.0f, -30.0f, 30.0f}}, {{-40.0f, -30.0f, 20.0f}},
                  {{10.0f, 30.0f, 40.0f}},  {{-30.0f, 40.0f, 10.0f}}, {{50.0f, 25.0f, 20.0f}},
                  {{-10.0f, -60.0f, 30.0f}}};
  const auto matt = [&](Vec3 color) {
    return add_material(scene, {.color = color, .shine = no_highlight, .refraction_index = 0.0f});
  };
  add_ground(scene, matt({0.2f, 0.7f, 0.2f}), 50.0f, 0.0f);
  add_branches(scene, matt({0.55f, 0.4f, 0.2f}), size, {});
}

}  // namespace bspview
