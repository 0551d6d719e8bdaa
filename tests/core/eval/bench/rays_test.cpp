#include "core/eval/bench/rays.h"

#include <gtest/gtest.h>

#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

class BenchRays : public ::testing::Test {
 protected:
  Scene scene = test::random_scene(100, 1);
  Tree tree = *build_scene_tree(scene, {});
  World world{scene, tree};

  std::vector<Ray> rays(BenchKind kind, std::size_t count = 1024) const {
    return record_bench_rays(world, kind, count, 5).rays;
  }
};

TEST_F(BenchRays, EyeRaysComeInTilesAndZOrder) {
  scene.camera.width = scene.camera.height = 512;
  const std::vector<Ray> all = rays(BenchKind::primary);
  ASSERT_EQ(all.size(), 1024u);
  const PrimaryRays picture(scene.camera, 32, 32);
  const auto expect_pixel = [&](std::size_t i, int x, int y) {
    const Vec3 direction =
        picture.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f).direction;
    EXPECT_LT(glm::length(all[i].direction - glm::normalize(direction)), 1e-6f) << i;
  };
  expect_pixel(0, 0, 0);
  expect_pixel(3, 1, 1);
  expect_pixel(4, 2, 0);
  expect_pixel(8, 0, 2);
  expect_pixel(16, 4, 0);
  expect_pixel(64, 8, 0);
  expect_pixel(4 * 64 + 63, 7, 15);
}

TEST_F(BenchRays, TheyAreOfUnitLengthAndTheSameEveryTime) {
  for (const BenchKind kind : {BenchKind::primary, BenchKind::shadow, BenchKind::scattered}) {
    const std::vector<Ray> all = rays(kind);
    EXPECT_GT(all.size(), 30u);
    EXPECT_LE(all.size(), 1024u);
    EXPECT_EQ(all, rays(kind));
    for (const Ray& ray : all) EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
  }
}

TEST_F(BenchRays, ShadowRaysEndAtTheLightsOneAfterTheOther) {
  ASSERT_EQ(scene.lights.size(), 2u);
  std::size_t light = 0;
  for (const Ray& ray : rays(BenchKind::shadow)) {
    const auto distance = [&](std::size_t i) {
      return glm::length(ray.at(ray.t_max) - scene.lights[i].position);
    };
    if (light == 0 && distance(1) < distance(0)) light = 1;
    EXPECT_LT(distance(light), 0.01f * ray.t_max);
  }
  EXPECT_EQ(light, 1u);
}

TEST_F(BenchRays, WhatIsNotSeenOrLitHasNone) {
  Scene dark = scene;
  dark.lights.clear();
  EXPECT_TRUE(record_bench_rays({dark, tree}, BenchKind::shadow, 256, 0).rays.empty());
  Scene away = scene;
  away.camera.at = 2.0f * away.camera.from - away.camera.at;
  EXPECT_TRUE(record_bench_rays({away, tree}, BenchKind::scattered, 256, 0).rays.empty());
  EXPECT_FALSE(record_bench_rays({away, tree}, BenchKind::primary, 256, 0).rays.empty());
}

TEST_F(BenchRays, AVeryFlatPictureHasATileAtLeast) {
  scene.camera.width = 4000;
  scene.camera.height = 1;
  EXPECT_EQ(rays(BenchKind::primary, 1).size() % 64, 0u);
  EXPECT_GE(rays(BenchKind::primary, 1).size(), 64u);
}

}  // namespace
}  // namespace bspview
