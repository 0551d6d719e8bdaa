#include "app/viewer/orbit_camera.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace bspview {
namespace {

constexpr PictureSize size{640, 480};
constexpr float nothing_hit = std::numeric_limits<float>::infinity();

/// A scene of side 2 * `scale` around `centre` with a camera that looks at it from the front.
struct View {
  Aabb box;
  Camera home;
};
View make_view(float scale, Vec3 centre = Vec3(0.0f)) {
  View view{{centre - scale, centre + scale}, {}};
  view.home.from = centre + scale * Vec3(1.0f, 2.0f, 6.0f);
  view.home.at = centre;
  return view;
}

Vec3 project(const OrbitCamera& orbit, Vec3 point) {
  return PrimaryRays(orbit.camera(), size.width, size.height).project(point);
}

/// The point at `depth` under a pixel.
Vec3 point_under(const OrbitCamera& orbit, Vec2 pixel, float depth) {
  return PrimaryRays(orbit.camera(), size.width, size.height).ray(pixel.x, pixel.y).at(depth);
}

void expect_at_pixel(const OrbitCamera& orbit, Vec3 point, Vec2 pixel) {
  const Vec3 at = project(orbit, point);
  EXPECT_NEAR(at.x, pixel.x, 0.1f);
  EXPECT_NEAR(at.y, pixel.y, 0.1f);
}

double elevation_degrees(const Camera& camera) {
  const Vec3d view = glm::normalize(Vec3d(camera.at) - Vec3d(camera.from));
  return std::asin(glm::dot(view, glm::normalize(Vec3d(camera.up)))) * 57.29577951308232;
}

const float scales[] = {1e-4f, 1.0f, 1e5f};

TEST(OrbitCamera, IsTheFilesCameraUntilItMovesAndAfterAReset) {
  const View view = make_view(1.0f);
  OrbitCamera orbit(view.home, view.box);
  EXPECT_EQ(orbit.camera(), view.home);
  orbit.orbit({100.0f, 30.0f}, size);
  EXPECT_NE(orbit.camera(), view.home);
  orbit.reset();
  EXPECT_EQ(orbit.camera(), view.home);
}

TEST(OrbitCamera, AMovementOfNothingKeepsThePicture) {
  for (const float scale : scales) {
    const View view = make_view(scale, Vec3(3.0f * scale));
    OrbitCamera orbit(view.home, view.box);
    const Vec3 point = point_under(orbit, {100.0f, 350.0f}, 5.0f * scale);
    orbit.orbit({0.0f, 0.0f}, size);
    expect_at_pixel(orbit, point, {100.0f, 350.0f});
  }
}

TEST(OrbitCamera, OrbitingKeepsThePivotsPixelAndDistance) {
  for (const float scale : scales) {
    const View view = make_view(scale);
    OrbitCamera orbit(view.home, view.box);
    const Vec3 before = project(orbit, orbit.pivot());
    test::Random random(3);
    for (int i = 0; i < 100; ++i) {
      orbit.orbit({random.between(-200.0f, 200.0f), random.between(-200.0f, 200.0f)}, size);
      expect_at_pixel(orbit, orbit.pivot(), before);
      EXPECT_NEAR(project(orbit, orbit.pivot()).z, before.z, 1e-4f * before.z);
    }
  }
}

TEST(OrbitCamera, TheFrontOfTheSceneFollowsTheDrag) {
  const View view = make_view(1.0f);
  OrbitCamera orbit(view.home, view.box);
  const Vec3 front = point_under(orbit, {320.0f, 240.0f}, project(orbit, orbit.pivot()).z - 0.5f);
  const Vec3 before = project(orbit, front);
  orbit.orbit({20.0f, 10.0f}, size);
  const Vec3 after = project(orbit, front);
  EXPECT_GT(after.x, before.x);
  EXPECT_GT(after.y, before.y);
}

TEST(OrbitCamera, NeverTurnsOverThePoles) {
  const View view = make_view(1.0f);
  for (const float direction : {-1.0f, 1.0f}) {
    OrbitCamera orbit(view.home, view.box);
    for (int i = 0; i < 100; ++i) orbit.orbit({3.0f, 50.0f * direction}, size);
    EXPECT_NEAR(std::abs(elevation_degrees(orbit.camera())), 89.5, 0.01);
    EXPECT_EQ(orbit.camera().up, view.home.up);
    // Away from the pole again the view turns smoothly on.
    orbit.orbit({0.0f, -100.0f * direction}, size);
    EXPECT_LT(std::abs(elevation_degrees(orbit.camera())), 60.0);
  }
}

TEST(OrbitCamera, ACameraThatLooksAlongItsUpCanTurn) {
  View view = make_view(1.0f);
  view.home.from = {0.0f, 5.0f, 0.0f};
  OrbitCamera orbit(view.home, view.box);
  const Vec3 point = point_under(orbit, {100.0f, 350.0f}, 4.0f);
  orbit.orbit({0.0f, 0.0f}, size);
  expect_at_pixel(orbit, point, {100.0f, 350.0f});
  orbit.orbit({50.0f, 50.0f}, size);
  EXPECT_TRUE(std::isfinite(glm::length(orbit.camera().from)));
  EXPECT_NEAR(glm::length(orbit.camera().from), 5.0f, 1e-3f);
}

TEST(OrbitCamera, PanningTakesThePointUnderTheCursorAlong) {
  for (const float scale : scales) {
    const View view = make_view(scale);
    OrbitCamera orbit(view.home, view.box);
    const Vec3 point = point_under(orbit, {100.0f, 100.0f}, 4.0f * scale);
    orbit.pan({100.0f, 100.0f}, {400.0f, 250.0f}, 4.0f * scale, size);
    expect_at_pixel(orbit, point, {400.0f, 250.0f});
  }
}

TEST(OrbitCamera, PanningOverNothingMovesThePivotWithTheCursor) {
  const View view = make_view(1.0f);
  OrbitCamera orbit(view.home, view.box);
  const Vec3 pivot = orbit.pivot();
  const Vec3 before = project(orbit, pivot);
  orbit.pan({10.0f, 10.0f}, {60.0f, 30.0f}, nothing_hit, size);
  expect_at_pixel(orbit, pivot, Vec2(before) + Vec2(50.0f, 20.0f));
}

TEST(OrbitCamera, TheWheelMovesTowardsThePointUnderTheCursor) {
  for (const float scale : scales) {
    const View view = make_view(scale);
    OrbitCamera orbit(view.home, view.box);
    const Vec2 pixel(500.0f, 100.0f);
    const float depth = 5.0f * scale;
    const Vec3 point = point_under(orbit, pixel, depth);
    orbit.dolly(2.0f, pixel, depth, size);
    expect_at_pixel(orbit, point, pixel);
    EXPECT_LT(project(orbit, point).z, 0.8f * depth);
    orbit.dolly(-2.0f, pixel, project(orbit, point).z, size);
    EXPECT_NEAR(project(orbit, point).z, depth, 1e-3f * depth);
  }
}

TEST(OrbitCamera, NoDollyingPassesThePointOrLeavesTheNumbers) {
  const View view = make_view(1.0f);
  for (const float notches : {1000.0f, -1000.0f}) {
    OrbitCamera orbit(view.home, view.box);
    for (int i = 0; i < 50; ++i) orbit.dolly(notches, {320.0f, 240.0f}, nothing_hit, size);
    const Camera camera = orbit.camera();
    EXPECT_TRUE(std::isfinite(glm::length(camera.from)));
    EXPECT_NE(camera.from, camera.at);
    EXPECT_GT(project(orbit, orbit.pivot()).z, 0.0f);
  }
}

TEST(OrbitCamera, RecentringBringsThePointToTheMiddleAndTurnsAboutIt) {
  const View view = make_view(1.0f);
  OrbitCamera orbit(view.home, view.box);
  const Vec3 point(0.5f, -0.3f, 0.8f);
  orbit.recentre(point);
  expect_at_pixel(orbit, point, {320.0f, 240.0f});
  orbit.orbit({77.0f, -35.0f}, size);
  expect_at_pixel(orbit, point, {320.0f, 240.0f});
}

TEST(OrbitCamera, FramingShowsTheWholeSceneFromTheSameDirection) {
  for (const float scale : scales) {
    const View view = make_view(scale, Vec3(scale));
    OrbitCamera orbit(view.home, view.box);
    orbit.orbit({130.0f, 20.0f}, size);
    const Camera before = orbit.camera();
    for (int i = 0; i < 5; ++i) orbit.dolly(3.0f, {600.0f, 20.0f}, nothing_hit, size);
    orbit.frame(size);
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner(i & 1 ? view.box.hi.x : view.box.lo.x,
                        i & 2 ? view.box.hi.y : view.box.lo.y,
                        i & 4 ? view.box.hi.z : view.box.lo.z);
      const Vec3 at = project(orbit, corner);
      EXPECT_TRUE(at.z > 0.0f && at.x > 0.0f && at.x < 640.0f && at.y > 0.0f && at.y < 480.0f);
    }
    const Vec3 direction = glm::normalize(orbit.camera().at - orbit.camera().from);
    EXPECT_NEAR(glm::dot(direction, glm::normalize(before.at - before.from)), 1.0f, 1e-5f);
  }
}

TEST(OrbitCamera, TurnsAboutTheSceneWhenTheFileLooksPastIt) {
  View view = make_view(1.0f);
  view.home.at = view.home.from + 100.0f * (view.home.at - view.home.from);
  const OrbitCamera orbit(view.home, view.box);
  EXPECT_LT(glm::length(orbit.pivot()), 0.1f);
}

TEST(OrbitCamera, StrangeScenesAndCamerasStayFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Camera still;
  still.at = still.from;
  Camera broken;
  broken.from = {nan, 0.0f, 0.0f};
  broken.up = Vec3(0.0f);
  for (const Camera& home : {Camera{}, still, broken}) {
    for (const Aabb& box : {Aabb{}, Aabb{Vec3(0.0f), Vec3(0.0f)}, Aabb{Vec3(-1.0f), Vec3(1.0f)}}) {
      OrbitCamera orbit(home, box);
      orbit.orbit({30.0f, 20.0f}, size);
      orbit.pan({0.0f, 0.0f}, {10.0f, 10.0f}, nothing_hit, size);
      orbit.dolly(1.0f, {5.0f, 5.0f}, nan, size);
      orbit.frame(size);
      orbit.recentre({0.0f, 0.0f, 0.0f});
      const Camera camera = orbit.camera();
      EXPECT_TRUE(std::isfinite(glm::length(camera.from)));
      EXPECT_TRUE(std::isfinite(glm::length(camera.at)));
      EXPECT_NE(camera.from, camera.at);
    }
  }
}

}  // namespace
}  // namespace bspview
