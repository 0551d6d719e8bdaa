#include "core/render/surface.h"

#include <gtest/gtest.h>

#include "core/render/scene_tree.h"
#include "tests/support/brute_force.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::Random;

TEST(Surface, NormalLooksAgainstTheRay) {
  const Scene scene = test::random_scene(100, 61);
  Random random(62);
  for (int trial = 0; trial < 5000; ++trial) {
    const Ray ray{random.point(2.0f), random.direction()};
    const Hit hit = test::brute_force(scene, ray);
    if (!hit) continue;
    const Surface surface = surface_at(scene, ray, hit);
    EXPECT_NEAR(glm::length(surface.normal), 1.0, 1e-12);
    EXPECT_LE(glm::dot(surface.normal, Vec3d(ray.direction)), 0.0);
    EXPECT_GT(glm::dot(surface.normal, surface.shading_normal), 0.0);
  }
}

/// One object of any kind, of about `size`, away from the origin by up to 1000 times as much.
Scene one_object(Random& random, float size) {
  Scene scene = test::random_scene(1, random.bits());
  const Vec3 place = random.point(random.below(2) == 0 ? 1.0f : 1000.0f);
  for (Vec3& vertex : scene.vertices) vertex = size * (vertex + place);
  for (Face& face : scene.faces) {
    if (face.plane != no_index) scene.planes[face.plane] = polygon_plane(vertices_of(scene, face));
  }
  for (Sphere& sphere : scene.spheres) {
    sphere = {size * (sphere.centre + place), size * sphere.radius};
  }
  for (Cone& cone : scene.cones) {
    cone = {size * (cone.base + place), size * cone.base_radius, size * (cone.apex + place),
            size * cone.apex_radius};
    scene.cone_frames = {ConeFrame(cone)};
  }
  return scene;
}

TEST(Surface, LeavingRayNeverHitsThePlaceItLeaves) {
  Random random(63);
  int left = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const float size = std::pow(10.0f, random.between(-8.0f, 8.0f));
    const Scene scene = one_object(random, size);
    const Aabb box = scene_bounds(scene);
    const Vec3 target = box.lo + Vec3(random.unit(), random.unit(), random.unit()) * box.extent();
    const Vec3 origin = box.centre() + 3.0f * size * random.direction();
    const Ray ray{origin, target - origin};
    const Hit hit = test::brute_force(scene, ray);
    if (!hit) continue;
    const Surface surface = surface_at(scene, ray, hit);
    for (int k = 0; k < 20; ++k) {
      Vec3d direction(random.direction());
      const double slope = glm::dot(direction, surface.normal);
      if (slope < 0.0) direction -= 2.0 * slope * surface.normal;
      const Vec3 rounded(direction);
      if (glm::dot(Vec3d(rounded), surface.normal) <= 0.0) continue;
      const Hit again =
          test::brute_force(scene, {leaving_origin(surface, Vec3d(rounded)), rounded});
      // A hollow object may be met again on its other side, but not where the ray starts.
      const double far = 1e-3 * size * std::abs(slope);
      ASSERT_TRUE(!again || again.t > far) << trial << " size " << size << " t " << again.t;
      ++left;
    }
  }
  EXPECT_GT(left, 50000);
}

TEST(LeavingOrigin, IsTheSecondFloatOutsideTheError) {
  Random random(11);
  int beside_zero = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    Surface surface;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = std::pow(10.0, random.between(-45.0f, 38.0f));
      const double place = random.between(-1.0f, 1.0f) * size;
      surface.point[axis] = trial % 2 == 0 ? place : static_cast<double>(static_cast<float>(place));
      surface.normal[axis] = trial % 3 == axis ? 0.0 : random.between(-1.0f, 1.0f);
      surface.error[axis] = trial % 5 == 0 ? 0.0 : 0x1p-24 * size;
    }
    const Vec3d direction(random.direction());
    const double reach = glm::dot(glm::abs(surface.normal), surface.error);
    const double side = glm::dot(direction, surface.normal) < 0.0 ? -1.0 : 1.0;
    const Vec3 origin = leaving_origin(surface, direction);
    for (int axis = 0; axis < 3; ++axis) {
      const double offset = (side * reach) * surface.normal[axis];
      const double moved = surface.point[axis] + offset;
      const float expected = offset > 0.0   ? next_up(round_up(moved))
                             : offset < 0.0 ? next_down(round_down(moved))
                                            : static_cast<float>(moved);
      ASSERT_EQ(origin[axis], expected) << trial << " from " << moved << " by " << offset;
      beside_zero += std::abs(moved) < 1e-37 ? 1 : 0;
    }
  }
  EXPECT_GT(beside_zero, 1000);
}

}  // namespace
}  // namespace bspview
