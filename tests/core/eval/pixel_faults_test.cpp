#include "core/eval/pixel_faults.h"

#include <gtest/gtest.h>

#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// A ball of radius 1 that fills the picture from as many radii away.
Scene far_ball(float distance) {
  Scene scene;
  add_sphere(scene, add_material(scene, {}), {{0, 0, 0}, 1.0f});
  scene.lights.push_back({.position = {0, -2 * distance, distance}});
  scene.camera.from = {0, -distance, 0};
  scene.camera.at = {0, 0, 0};
  scene.camera.up = {0, 0, 1};
  scene.camera.angle_degrees = 2.2f * 57.29578f / distance;
  return scene;
}

PixelFaults faults_of(const Scene& scene, const RenderParams& params) {
  const Tree tree = *build_scene_tree(scene, {});
  PixelFaults last;
  const World world{scene, tree};
  const Reference reference(scene);
  find_pixel_faults({world, reference, scene.camera, params}, {},
                    [&](const PixelFaults& faults) { last = faults; });
  return last;
}

RenderParams small(Arithmetic arithmetic, OffsetRule offset = OffsetRule::error_bounded) {
  RenderParams params;
  params.width = params.height = 64;
  params.arithmetic = arithmetic;
  params.offset = offset;
  return params;
}

TEST(PixelFaults, PicturesHaveNone) {
  for (const Scene& scene : {far_ball(1e4f), test::random_scene(200, 5)}) {
    const PixelFaults faults = faults_of(scene, small(Arithmetic::exact));
    EXPECT_TRUE(faults.complete);
    EXPECT_EQ(faults.checked, 64u * 64u);
    EXPECT_EQ(faults.lost + faults.phantom + faults.self_hit, 0u);
  }
}

TEST(PixelFaults, TheTextbookQuadraticRuinsTheRimOfAFarBall) {
  const PixelFaults faults = faults_of(far_ball(1e4f), small(Arithmetic::textbook));
  EXPECT_GT(faults.lost + faults.phantom, 50u);
  const PixelFault middle = faults.pixels[32 * 64 + 32];
  EXPECT_TRUE(middle == PixelFault::none || middle == PixelFault::self_hit);
}

TEST(PixelFaults, AFixedOffsetLetsAFarSurfaceHitItself) {
  const Vec3 centre(1e5f, 2e5f, -1e5f);
  Scene lit = test::random_scene(200, 5, centre);
  lit.lights = {{.position = centre + Vec3(9, -8, 7)}};
  EXPECT_GT(faults_of(lit, small(Arithmetic::exact, OffsetRule::fixed)).self_hit, 50u);
  EXPECT_EQ(faults_of(lit, small(Arithmetic::exact)).self_hit, 0u);
}

TEST(PixelFaults, AHitThatIsFoundBelowItsSurfaceShadesItself) {
  // In float the hit is off by more than what the offset allows for.
  Scene scene = test::cube_grid(4, {0.1f, 0.2f, 0.3f});
  scene.lights = {{.position = {9, 8, 7}}};
  scene.camera = {{30, 23, 41}, {0.1f, 0.2f, 0.3f}, {0, 1, 0}, 3.0f};
  EXPECT_GT(faults_of(scene, small(Arithmetic::textbook)).self_hit, 200u);
  EXPECT_EQ(faults_of(scene, small(Arithmetic::exact)).self_hit, 0u);
}

TEST(PixelFaults, PassesRefineAndEndWhenStopped) {
  const Scene scene = far_ball(10.0f);
  const Tree tree = *build_scene_tree(scene, {});
  const World world{scene, tree};
  const Reference reference(scene);
  const RenderParams params = small(Arithmetic::exact);
  const JudgedPicture picture{world, reference, scene.camera, params};
  std::vector<std::size_t> checked;
  find_pixel_faults(picture, {},
                    [&](const PixelFaults& faults) { checked.push_back(faults.checked); });
  EXPECT_EQ(checked, (std::vector<std::size_t>{16, 64, 256, 1024, 4096}));
  std::stop_source stop;
  int passes = 0;
  find_pixel_faults(picture, stop.get_token(), [&](const PixelFaults&) {
    ++passes;
    stop.request_stop();
  });
  EXPECT_EQ(passes, 1);
}

}  // namespace
}  // namespace bspview
