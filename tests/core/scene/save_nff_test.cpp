#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "core/scene/load.h"

namespace bspview {
namespace {

/// Any finite float with the same chance for every bit pattern.
float random_float(std::mt19937& random) {
  for (;;) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) return value;
  }
}

Vec3 random_vec3(std::mt19937& random) {
  return {random_float(random), random_float(random), random_float(random)};
}

Scene random_scene(std::mt19937& random) {
  Scene scene;
  scene.name = "random";
  scene.background = random_vec3(random);
  scene.camera = {random_vec3(random), random_vec3(random), random_vec3(random), 33.3f, 0.1f, 7, 9};
  scene.lights = {{random_vec3(random), Vec3(1)}, {random_vec3(random), random_vec3(random)}};
  for (int i = 0; i < 40; ++i) {
    const std::uint32_t material =
        add_material(scene, {random_vec3(random), random_float(random), random_float(random),
                             random_float(random), random_float(random), random_float(random)});
    std::vector<Vec3> vertices(3 + random() % 5), normals(i % 2 ? vertices.size() : 0);
    for (Vec3& vertex : vertices) vertex = random_vec3(random);
    for (Vec3& normal : normals) normal = random_vec3(random);
    add_face(scene, material, vertices, normals);
    add_sphere(scene, material, {random_vec3(random), random_float(random)});
    add_cone(
        scene, i % 3 ? material : 0,
        {random_vec3(random), random_float(random), random_vec3(random), random_float(random)});
  }
  return scene;
}

TEST(SaveNff, NineDigitsKeepEveryFloat) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const Scene scene = random_scene(random);
    const Result<Scene> back = parse_nff(format_nff(scene), "random.nff");
    ASSERT_TRUE(back.ok()) << "seed " << seed << ": " << back.error().message;
    EXPECT_EQ(*back, scene) << "seed " << seed;
  }
}

TEST(SaveNff, SixDigitsAreWrittenAsTheStandardScenesHaveThem) {
  Scene scene;
  scene.background = {0.078f, 0.361f, 0.753f};
  scene.camera = {{2.1f, 1.3f, 1.7f}, {0, 0, 0}, {0, 0, 1}, 45.0f, 0.01f, 512, 512};
  scene.lights = {{{4, 3, 2}, Vec3(1)}, {{-3, 1, 5}, {1, 0.5f, 0}}};
  add_material(scene, {{1, 0.75f, 0.33f}, 0.8f, 0, 100000, 0, 1});
  add_sphere(scene, 0, {{0.27216554f, 0.2f, -1e6f}, 0.16666667f});
  add_cone(scene, 0, {{0, 0, 0}, -1, {0, 0, 1}, -2});
  const Vec3 corners[] = {{12, 12, -0.5f}, {-12, 12, -0.5f}, {-12, -12, -0.5f}};
  add_face(scene, 0, corners);
  add_face(scene, 0, corners, corners);
  EXPECT_EQ(format_nff(scene, 6), R"(b 0.078 0.361 0.753
v
from 2.1 1.3 1.7
at 0 0 0
up 0 0 1
angle 45
hither 0.01
resolution 512 512
l 4 3 2
l -3 1 5 1 0.5 0
f 1 0.75 0.33 0.8 0 100000 0 1
s 0.272166 0.2 -1e+06 0.166667
c 0 0 0 -1 0 0 1 -2
p 3
12 12 -0.5
-12 12 -0.5
-12 -12 -0.5
pp 3
12 12 -0.5 12 12 -0.5
-12 12 -0.5 -12 12 -0.5
-12 -12 -0.5 -12 -12 -0.5
)");
}

}  // namespace
}  // namespace bspview
