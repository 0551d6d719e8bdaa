#include "core/render/test_cost.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

constexpr std::size_t index_of(ObjectKind kind) {
  return static_cast<std::size_t>(kind);
}

TEST(TestCost, SharesAreOfTheSurfaceOfBoxes) {
  Scene scene;
  const std::uint32_t material = add_material(scene, {});
  add_sphere(scene, material, {.centre = Vec3(0.0f), .radius = 1.0f});
  add_sphere(scene, material, {.centre = Vec3(9.0f), .radius = 1.0f});
  const Vec3 corners[] = {Vec3(0.0f), Vec3(1.0f, 0.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f)};
  add_face(scene, material, corners);
  const std::vector<Aabb> boxes{{Vec3(-1.0f), Vec3(1.0f)},  // 12 are half of its surface
                                {},                         // not placed
                                {Vec3(0.0f), Vec3(2.0f, 2.0f, 0.0f)}};
  const auto shares = surface_shares(scene, boxes);
  EXPECT_DOUBLE_EQ(shares[index_of(ObjectKind::sphere)], 0.75);
  EXPECT_DOUBLE_EQ(shares[index_of(ObjectKind::triangle)], 0.25);
  EXPECT_FLOAT_EQ(mean_test_cost(scene, boxes),
                  static_cast<float>(0.75 * test_costs[index_of(ObjectKind::sphere)] +
                                     0.25 * test_costs[index_of(ObjectKind::triangle)]));
}

TEST(TestCost, SharesAddUpToOneWhateverThereIs) {
  Scene points;
  add_sphere(points, add_material(points, {}), {.centre = Vec3(1.0f), .radius = 0.0f});
  for (const Scene& scene : {Scene{}, points, test::random_scene(200, 1)}) {
    const auto shares = surface_shares(scene, object_bounds(scene));
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
  }
}

TEST(TestCost, TreesAreBuiltWithTheMeanOfTheScene) {
  const Scene scene = test::random_scene(200, 2);
  const float mean = mean_test_cost(scene, object_bounds(scene));
  const auto automatic = build_scene_tree(scene, {});
  const auto same = build_scene_tree(scene, {.cost_intersection = mean});
  const auto other = build_scene_tree(scene, {.cost_intersection = 0.01f});
  ASSERT_TRUE(automatic.ok() && same.ok() && other.ok());
  EXPECT_EQ(automatic->cost_intersection, mean);
  EXPECT_EQ(other->cost_intersection, 0.01f);
  EXPECT_EQ(automatic->nodes, same->nodes);
  EXPECT_NE(automatic->nodes, other->nodes);
}

}  // namespace
}  // namespace bspview
