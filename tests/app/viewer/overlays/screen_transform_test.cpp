#include "app/viewer/overlays/screen_transform.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace bspview {
namespace {

TEST(ScreenTransform, AgreesWithTheRaysOfThePicture) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    Camera camera;
    camera.from = random.point(50.0f);
    camera.at = random.point(50.0f);
    camera.up = random.direction();
    camera.angle_degrees = random.between(10.0f, 100.0f);
    const PrimaryRays rays(camera, 640, 480);
    const ScreenTransform transform(camera, 640, 480);
    const float x = random.between(0.0f, 640.0f), y = random.between(0.0f, 480.0f);
    const float t = random.between(1.0f, 100.0f);
    const Vec3 point = transform.homogeneous(rays.ray(x, y).at(t));
    EXPECT_NEAR(point.z, t, 1e-4f * t);
    EXPECT_NEAR(point.x / point.z, x, 0.05f);
    EXPECT_NEAR(point.y / point.z, y, 0.05f);
  }
}

TEST(ScreenTransform, PointsBehindTheEyeHaveNoPositiveDepth) {
  const Camera camera;  // from (0, 0, 1) towards the origin
  const ScreenTransform transform(camera, 100, 100);
  EXPECT_GT(transform.homogeneous({0.0f, 0.0f, 0.0f}).z, 0.0f);
  EXPECT_LE(transform.homogeneous({0.0f, 0.0f, 1.0f}).z, 0.0f);
  EXPECT_LT(transform.homogeneous({0.0f, 0.0f, 2.0f}).z, 0.0f);
}

TEST(ScreenTransform, APixelSideSpansOnePixelAtDepthOne) {
  const Camera camera;
  const ScreenTransform transform(camera, 300, 200);
  const float side = transform.pixel_size();
  const Vec3 middle = transform.homogeneous({0.0f, 0.0f, 0.0f});
  const Vec3 beside = transform.homogeneous({side, 0.0f, 0.0f});
  EXPECT_NEAR(beside.x - middle.x, 1.0f, 1e-3f);
}

}  // namespace
}  // namespace bspview
