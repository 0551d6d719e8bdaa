#include "core/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bspview {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

bool is_finite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double degrees_between(Vec3 a, Vec3 b) {
  return std::acos(glm::dot(glm::normalize(Vec3d(a)), glm::normalize(Vec3d(b)))) * 180.0 / M_PI;
}

Camera balls_camera() {
  Camera camera;
  camera.from = {2.1f, 1.3f, 1.7f};
  camera.up = {0.0f, 0.0f, 1.0f};
  return camera;
}

TEST(PrimaryRays, TheAngleIsBetweenTheCentresOfTheOutermostRows) {
  const PrimaryRays rays(balls_camera(), 512, 512);
  EXPECT_NEAR(degrees_between(rays.ray(256.0f, 0.5f).direction, rays.ray(256.0f, 511.5f).direction),
              45.0, 1e-4);
  EXPECT_NEAR(degrees_between(rays.ray(0.5f, 256.0f).direction, rays.ray(511.5f, 256.0f).direction),
              45.0, 1e-4);
}

TEST(PrimaryRays, PixelsAreSquareInAWidePicture) {
  const PrimaryRays rays(balls_camera(), 1024, 512);
  const Vec3 corner = rays.ray(0.0f, 0.0f).direction;
  const float right = glm::length(rays.ray(1.0f, 0.0f).direction - corner);
  const float down = glm::length(rays.ray(0.0f, 1.0f).direction - corner);
  EXPECT_NEAR(right / down, 1.0f, 1e-3f);
  EXPECT_NEAR(degrees_between(rays.ray(512.0f, 0.5f).direction, rays.ray(512.0f, 511.5f).direction),
              45.0, 1e-4);
}

TEST(PrimaryRays, TheMiddleOfThePictureLooksAtTheTarget) {
  const Camera camera = balls_camera();
  const PrimaryRays rays(camera, 640, 480);
  EXPECT_NEAR(degrees_between(rays.ray(320.0f, 240.0f).direction, camera.at - camera.from), 0.0,
              1e-4);
}

TEST(PrimaryRays, UpIsTowardsTheFirstRowAndRightTowardsTheLastColumn) {
  Camera camera;
  camera.from = {0.0f, 0.0f, 5.0f};
  const PrimaryRays rays(camera, 64, 64);
  EXPECT_GT(rays.ray(32.0f, 0.0f).direction.y, 0.0f);
  EXPECT_GT(rays.ray(64.0f, 32.0f).direction.x, 0.0f);
}

TEST(PrimaryRays, ProjectGivesThePixelOfThePointOnARay) {
  const PrimaryRays rays(balls_camera(), 300, 200);
  for (const Vec2 pixel : {Vec2(0.0f, 0.0f), Vec2(17.25f, 150.5f), Vec2(300.0f, 200.0f)}) {
    const Vec3 back = rays.project(rays.ray(pixel.x, pixel.y).at(3.0f));
    EXPECT_NEAR(back.x, pixel.x, 2e-3f);
    EXPECT_NEAR(back.y, pixel.y, 2e-3f);
    EXPECT_NEAR(back.z, 3.0f, 1e-5f);
  }
}

TEST(PrimaryRays, APointBehindTheEyeHasNoPositiveDepth) {
  const Camera camera = balls_camera();
  const PrimaryRays rays(camera, 300, 200);
  EXPECT_LT(rays.project(camera.from + (camera.from - camera.at)).z, 0.0f);
  EXPECT_EQ(rays.project(camera.from).z, 0.0f);
}

void expect_usable(const Camera& camera) {
  for (const int side : {1, 2, 64}) {
    const PrimaryRays rays(camera, side, side);
    for (const float x : {0.0f, 0.5f * side, 1.0f * side}) {
      const Ray ray = rays.ray(x, x);
      EXPECT_TRUE(is_finite(ray.origin));
      EXPECT_TRUE(is_finite(ray.direction));
      EXPECT_GT(glm::length(ray.direction), 0.5f);
    }
  }
}

TEST(PrimaryRays, AreUsableForEveryCameraHoweverBroken) {
  for (const float bad : {0.0f, nan, infinity, -infinity, 3e38f, 1e-45f}) {
    Camera camera = balls_camera();
    camera.from.x = bad;
    expect_usable(camera);
    camera = balls_camera();
    camera.at = Vec3(bad);
    expect_usable(camera);
    camera = balls_camera();
    camera.up = Vec3(0.0f, 0.0f, bad);
    expect_usable(camera);
    camera = balls_camera();
    camera.angle_degrees = bad;
    expect_usable(camera);
  }
  Camera camera = balls_camera();
  camera.at = camera.from;
  expect_usable(camera);
}

TEST(PrimaryRays, UpAlongTheViewStillGivesAPicture) {
  for (const Vec3 axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 2, 3)}) {
    for (const float sign : {1.0f, -1.0f}) {
      Camera camera;
      camera.from = 4.0f * axis;
      camera.up = sign * axis;
      expect_usable(camera);
    }
  }
}

void expect_framed(const Aabb& box, Vec3 direction, Vec3 up, float aspect) {
  const Camera camera = frame_box(box, direction, up, aspect);
  EXPECT_NEAR(static_cast<float>(camera.width) / camera.height, aspect, 0.01f * aspect);
  const PrimaryRays rays(camera, camera.width, camera.height);
  float largest = 0.0f;  // reach of the box in half pictures
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                      i & 4 ? box.hi.z : box.lo.z);
    const Vec3 pixel = rays.project(corner);
    EXPECT_GT(pixel.z, 0.0f);
    largest = std::max({largest, std::abs(2.0f * pixel.x / camera.width - 1.0f),
                        std::abs(2.0f * pixel.y / camera.height - 1.0f)});
  }
  EXPECT_LE(largest, 1.0f);
  EXPECT_GE(largest, 0.9f);
}

TEST(FrameBox, TheBoxFillsThePictureFromEveryDirection) {
  const Aabb boxes[] = {{Vec3(-1), Vec3(1)},
                        {Vec3(0, 0, 0), Vec3(100, 1, 1)},
                        {Vec3(-1, 0, -1), Vec3(1, 0, 1)},
                        {Vec3(1000, 1000, 1000), Vec3(1001, 1002, 1003)},
                        {Vec3(-1e-6f), Vec3(1e-6f)},
                        {Vec3(-1e12f), Vec3(1e12f)}};
  for (const Aabb& box : boxes)
    for (const Vec3 direction : {Vec3(0, 0, -1), Vec3(1, 1, 1), Vec3(-3, 0.5f, -2)})
      for (const float aspect : {0.4f, 1.0f, 16.0f / 9.0f})
        expect_framed(box, direction, {0.0f, 1.0f, 0.0f}, aspect);
}

TEST(FrameBox, GivesAUsableCameraForBoxesThatSayNothing) {
  const Aabb boxes[] = {{},
                        {Vec3(0), Vec3(0)},
                        {Vec3(1e6f), Vec3(1e6f)},
                        {Vec3(-infinity), Vec3(infinity)},
                        {Vec3(nan), Vec3(nan)}};
  for (const Aabb& box : boxes) {
    for (const Vec3 direction : {Vec3(0), Vec3(nan), Vec3(0, 1, 0)}) {
      const Camera camera = frame_box(box, direction, {0.0f, 1.0f, 0.0f}, nan);
      EXPECT_TRUE(is_finite(camera.from) && is_finite(camera.at) && is_finite(camera.up));
      EXPECT_NE(camera.from, camera.at);
      expect_usable(camera);
    }
  }
}

}  // namespace
}  // namespace bspview
