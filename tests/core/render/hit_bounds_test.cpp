#include "core/render/hit_bounds.h"

#include <gtest/gtest.h>

#include "core/render/intersect.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::Random;

Aabb cell_around(Vec3 point, Random& random) {
  const Vec3 below = glm::abs(random.point(0.3f)), above = glm::abs(random.point(0.3f));
  return {point - below, point + above};
}

bool is_within(const Vec3d& point, const Aabb& box, double slack) {
  bool within = true;
  for (int axis = 0; axis < 3; ++axis) {
    within = within && box.lo[axis] - slack <= point[axis] && point[axis] <= box.hi[axis] + slack;
  }
  return within;
}

TEST(HitBounds, InACellHoldWhatRaysHitThere) {
  Random random(1);
  for (const Vec3 centre : {Vec3(0.0f), Vec3(30.0f, -7.0f, 0.1f), Vec3(3000.0f)}) {
    const Scene scene = test::random_scene(400, 5, centre);
    const double slack = 0x1p-21 * (largest_component(glm::abs(centre)) + 5.0);
    int hits = 0, cuts = 0;
    for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
      const Aabb whole = hit_bounds(scene, id);
      for (int trial = 0; trial < 100; ++trial) {
        const Vec3 origin = centre + 4.0f * random.direction();
        const Ray ray{origin, whole.centre() + random.point(0.1f) - origin};
        const double t = hit_object(scene, id, RayQuery(ray), SideRule::two_sided);
        if (t == no_hit) continue;
        const Vec3d point = Vec3d(ray.origin) + t * Vec3d(ray.direction);
        const Aabb cell = cell_around(Vec3(point), random);
        const Aabb part = hit_bounds(scene, id, whole, cell);
        ASSERT_TRUE(is_within(point, part, slack)) << "object " << id;
        ASSERT_TRUE(intersection(whole, cell).contains(part)) << "object " << id;
        ++hits;
        cuts += part == intersection(whole, cell) ? 0 : 1;
      }
    }
    EXPECT_GT(hits, 3000);
    EXPECT_GT(cuts, 300);
  }
}

TEST(HitBounds, OfAPolygonAcrossAnAxisAreFlat) {
  const Scene scene = test::cube_grid(2, Vec3(0.3f));
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    const Vec3 size = hit_bounds(scene, id).extent();
    EXPECT_EQ(size.x * size.y * size.z, 0.0f);
  }
}

}  // namespace
}  // namespace bspview
