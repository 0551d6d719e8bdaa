#include "core/render/test_cost.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

TEST(TestCost, TheMeanIsByTheNumberOfObjects) {
  Scene scene;
  const std::uint32_t material = add_material(scene, {});
  add_sphere(scene, material, {.centre = Vec3(0.0f), .radius = 1.0f});
  const Vec3 corners[] = {Vec3(0.0f), Vec3(1.0f, 0.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f)};
  for (int i = 0; i < 3; ++i) add_face(scene, material, corners);
  EXPECT_EQ(mean_test_cost({1.0f, 9.0f, 5.0f, 9.0f}, scene), 2.0f);  // triangles, spheres
  EXPECT_GT(mean_test_cost(default_test_costs, {}), 0.0f);
}

TEST(TestCost, APolygonCostsAsItHasCorners) {
  Scene scene;
  const std::uint32_t material = add_material(scene, {});
  const Vec3 corners[] = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}, {-1, 1, 0}};
  add_face(scene, material, std::span(corners).first(4));
  add_face(scene, material, corners);
  const TestCosts costs{1.0f, 2.0f, 1.0f, 1.0f};
  EXPECT_EQ(test_cost(costs, scene, scene.objects[0]), 8.0f);
  EXPECT_EQ(test_cost(costs, scene, scene.objects[1]), 12.0f);
  EXPECT_EQ(mean_test_cost(costs, scene), 10.0f);
}

TEST(TestCost, TheMeanIsThatOfTheObjects) {
  for (const SpdScene& spd : spd_scenes()) {
    const Scene scene = *make_spd(spd.name);
    double sum = 0.0;
    for (const Object& object : scene.objects) sum += test_cost(default_test_costs, scene, object);
    const double mean = sum / static_cast<double>(scene.objects.size());
    EXPECT_NEAR(mean_test_cost(default_test_costs, scene), mean, 1e-6 * mean) << spd.name;
  }
}

/// Objects of the leaf with the most.
std::uint32_t largest_leaf(const Tree& tree) {
  std::uint32_t most = 0;
  for (const Node& node : tree.nodes) {
    if (node.is_leaf()) most = std::max(most, node.count());
  }
  return most;
}

TEST(TestCost, ObjectsThatCostMoreAreInSmallerLeaves) {
  const Scene scene = test::random_triangles(2000, 3);
  for (const Builder builder : {Builder::sah, Builder::sah_binned}) {
    const BuildParams params{.builder = builder};
    const auto cheap = build_scene_tree(scene, params, {}, {0.1f, 1.0f, 1.0f, 1.0f});
    const auto dear = build_scene_tree(scene, params, {}, {4.0f, 1.0f, 1.0f, 1.0f});
    ASSERT_TRUE(cheap.ok() && dear.ok());
    EXPECT_GT(largest_leaf(*cheap), largest_leaf(*dear));
    EXPECT_LT(cheap->nodes.size(), dear->nodes.size());
  }
}

TEST(TestCost, ThatOfOneKindChangesNoTreeOfOthers) {
  const Scene scene = test::random_triangles(500, 4);
  const auto one = build_scene_tree(scene, {}, {}, {0.5f, 1.0f, 1.0f, 1.0f});
  const auto same = build_scene_tree(scene, {}, {}, {0.5f, 7.0f, 8.0f, 9.0f});
  const auto asked_for = build_scene_tree(scene, {.cost_intersection = 0.5f});
  ASSERT_TRUE(one.ok() && same.ok() && asked_for.ok());
  EXPECT_EQ(one->nodes, same->nodes);
  EXPECT_EQ(one->nodes, asked_for->nodes);
}

TEST(TestCost, WhatIsAskedForIsTheSameForAllKinds) {
  const Scene scene = test::random_scene(300, 5);
  const BuildParams params{.cost_intersection = 1.0f};
  const auto one = build_scene_tree(scene, params, {}, {1.0f, 2.0f, 3.0f, 4.0f});
  const auto other = build_scene_tree(scene, params);
  ASSERT_TRUE(one.ok() && other.ok());
  EXPECT_EQ(one->nodes, other->nodes);
  EXPECT_EQ(one->cost_intersection, 1.0f);
}

}  // namespace
}  // namespace bspview
