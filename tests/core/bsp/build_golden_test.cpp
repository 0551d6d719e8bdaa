// Published figures: an independent program's, and those of the octree that visits the same cells.

#include <gtest/gtest.h>

#include "core/bsp/stats.h"
#include "core/bsp/validate.h"
#include "core/eval/delta.h"
#include "core/render/intersect.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

Tree build_spd(std::string_view name, const BuildParams& params) {
  const auto scene = make_spd(name);
  EXPECT_TRUE(scene.ok());
  auto tree = build_scene_tree(*scene, params);
  EXPECT_TRUE(tree.ok());
  EXPECT_TRUE(validate(*tree, SceneBuildInput(*scene).input()).ok());
  return std::move(*tree);
}

/// Objects tested by rays all through the scene.
std::uint64_t count_tests(const Scene& scene, const BuildParams& params) {
  const auto tree = build_scene_tree(scene, params);
  EXPECT_TRUE(tree.ok());
  const Vec3 centre = tree->box.centre(), half = 0.5f * tree->box.extent();
  test::Random random(1);
  RayCost cost;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 origin = centre + 2.0f * half * random.point(1.0f);
    CountObserver count(cost);
    closest_hit({scene, *tree}, {origin, centre + half * random.point(1.0f) - origin}, {}, count);
  }
  return cost.tests;
}

Delta median_delta(std::string_view name) {
  const Tree tree = build_spd(name, {.builder = Builder::median, .max_depth = 16, .leaf_size = 2});
  return compute_delta(tree_stats(tree), tree.object_count);
}

TEST(BuildGolden, MedianTreeOfBalls) {
  const Delta delta = median_delta("balls");
  EXPECT_EQ(delta.n_ls, 584u);
  EXPECT_NEAR(*delta.r_etnls, 0.442, 0.0005);
  EXPECT_NEAR(*delta.n_adl, 1.54, 0.005);
  EXPECT_NEAR(*delta.n_aoial, 19.5, 0.05);
  EXPECT_NEAR(*delta.n_aoifl, 34.9, 0.1);
  EXPECT_NEAR(*delta.r_fvwv, 0.434, 0.0005);
}

TEST(BuildGolden, MedianTreeOfTetra) {
  const Delta delta = median_delta("tetra");
  EXPECT_EQ(delta.n_ls, 12624u);
  EXPECT_NEAR(*delta.r_etnls, 0.348, 0.0005);
  EXPECT_NEAR(*delta.n_adl, 12.0, 0.05);
  EXPECT_NEAR(*delta.n_aoial, 3.89, 0.005);
  EXPECT_NEAR(*delta.n_aoifl, 5.97, 0.005);
  EXPECT_NEAR(*delta.r_fvwv, 0.126, 0.0005);
}

TEST(BuildGolden, MedianTreeOfTetraHasTheReferencesOfTheOctree) {
  BuildParams params{.builder = Builder::median, .max_depth = 12, .leaf_size = 1};
  EXPECT_EQ(build_spd("tetra", params).references.size(), 13312u);
  params.max_depth = 15;
  EXPECT_EQ(build_spd("tetra", params).references.size(), 32768u);
}

TEST(BuildGolden, CostDrivenTreesAreCheaperThanTheMedianTree) {
  for (const std::string_view name : {"balls", "tetra", "tree"}) {
    const auto cost = [&](Builder builder) {
      return tree_stats(build_spd(name, {.builder = builder, .max_depth = 18})).expected_cost;
    };
    const double median = cost(Builder::median);
    EXPECT_LT(cost(Builder::sah), median) << name;
    EXPECT_LT(cost(Builder::sah_binned), median) << name;
    EXPECT_LT(cost(Builder::mb), median) << name;
  }
}

TEST(BuildGolden, BinsCostAtMostThreePercent) {
  for (const std::string_view name : {"gears", "lattice", "mount", "nurbtst", "teapot", "tetra"}) {
    const auto scene = make_spd(name);
    ASSERT_TRUE(scene.ok());
    const auto cost = [&](Builder builder) {
      return tree_stats(*build_scene_tree(*scene, {.builder = builder})).expected_cost;
    };
    EXPECT_LT(cost(Builder::sah_binned), 1.03 * cost(Builder::sah)) << name;
  }
}

TEST(BuildGolden, ClippedTreesTestFewerObjectsARay) {
  for (const std::string_view name : {"gears", "mount", "nurbtst", "rings", "teapot", "tetra"}) {
    const auto scene = make_spd(name);
    ASSERT_TRUE(scene.ok());
    // Bins tell planes apart only in cells that are large beside the objects: small leaves.
    for (BuildParams params :
         {BuildParams{.builder = Builder::sah},
          BuildParams{.builder = Builder::sah, .cost_intersection = 1.0f},
          BuildParams{.builder = Builder::sah_binned, .cost_intersection = 1.0f}}) {
      const auto tests = [&](bool clip) {
        params.clip = clip;
        return count_tests(*scene, params);
      };
      EXPECT_LE(tests(true), tests(false)) << name << ", " << name_of(params.builder);
    }
  }
}

TEST(BuildGolden, ClippingMakesTheSweptTreeOfTetraCheaper) {
  BuildParams params{.clip = true};
  const double parts = tree_stats(build_spd("tetra", params)).expected_cost;
  params.clip = false;
  EXPECT_LT(parts, tree_stats(build_spd("tetra", params)).expected_cost);
}

}  // namespace
}  // namespace bspview
