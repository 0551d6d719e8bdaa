#include "core/scene/default_view.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(DefaultView, ShowsTheWholeBoxWithZUp) {
  const Camera camera = make_default_view({Vec3(-3, -2, 0), Vec3(3, 2, 9)});
  const PrimaryRays rays(camera, camera.width, camera.height);
  EXPECT_LT(rays.project({0, 0, 9}).y, rays.project({0, 0, 0}).y);
  EXPECT_GT(camera.from.x, camera.at.x);
  EXPECT_GT(camera.from.z, camera.at.z);
}

TEST(DefaultView, TheLightIsAboveAndToTheLeftOfTheEye) {
  const Camera camera{.from = {0, -8, 0}, .at = {0, 0, 0}, .up = {0, 0, 3}};
  EXPECT_EQ(make_default_light(camera), (Light{{-2, -8, 4}, Vec3(1)}));
}

TEST(DefaultView, TheLightIsAtTheEyeWhenUpHasNoDirection) {
  const Camera camera{.from = {0, -8, 0}, .at = {0, 0, 0}, .up = {0, 0, 0}};
  EXPECT_EQ(make_default_light(camera).position, camera.from);
}

}  // namespace
}  // namespace bspview
