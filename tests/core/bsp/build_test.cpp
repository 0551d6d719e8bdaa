#include "core/bsp/build.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/box_sets.h"
#include "tests/support/builds.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::BoxSet;
using test::describe;
using test::every_way;
using test::expect_same;
using test::expect_valid;

TEST(Build, NamesFollowTheEnumerators) {
  EXPECT_EQ(name_of(Builder::naive), "naive");
  EXPECT_EQ(name_of(Builder::median), "median");
  EXPECT_EQ(name_of(Builder::median_longest), "median-longest");
  EXPECT_EQ(name_of(Builder::object_median), "object-median");
  EXPECT_EQ(name_of(Builder::mb), "mb");
  EXPECT_EQ(name_of(Builder::sah), "sah");
  EXPECT_EQ(name_of(Builder::sah_binned), "sah-binned");
  EXPECT_EQ(builder_names().size(), 7u);
}

TEST(Build, TreesAreTheSameByEveryInstructionSet) {
  const BoxSet set = test::random_boxes(500, 7);
  for (const BuildParams& params : every_way({.cost_intersection = 1.0f})) {
    const auto tree = build_tree(set.input(), params);
    ASSERT_TRUE(tree.ok());
    for (const std::int64_t instructions : test::instruction_sets()) {
      SCOPED_TRACE(describe(params) + ", " + hwy::TargetName(instructions));
      const test::OneInstructionSet only(instructions);
      const auto same = build_tree(set.input(), params);
      ASSERT_TRUE(same.ok());
      expect_same(*same, *tree);
    }
  }
}

/// A ring of teeth in a tilted plane.
std::vector<Vec3> gear(int teeth) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 4 * teeth; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(4 * teeth);
    const float radius = i % 4 < 2 ? 1.0f : 0.9f;
    const float x = radius * std::cos(angle), y = radius * std::sin(angle);
    corners.push_back({x, y, 0.3f * x});
  }
  return corners;
}

// Outlines of up to 256 corners are kept while their parts are cut, others are found anew.
TEST(Build, TreesOfPolygonsOfManyCornersAreTheSameByEveryInstructionSet) {
  for (const int teeth : {20, 36, 200}) {
    Scene scene = test::random_scene(100, 7);
    add_face(scene, 0, gear(teeth));
    const SceneBuildInput objects(scene);
    for (const BuildParams& params : every_way({.cost_intersection = 8.0f})) {
      SCOPED_TRACE(fmt::format("{} teeth, {}", teeth, describe(params)));
      expect_valid(objects.input(), params);
      const auto tree = build_tree(objects.input(), params);
      ASSERT_TRUE(tree.ok());
      for (const std::int64_t instructions : test::instruction_sets()) {
        SCOPED_TRACE(hwy::TargetName(instructions));
        const test::OneInstructionSet only(instructions);
        const auto same = build_tree(objects.input(), params);
        ASSERT_TRUE(same.ok());
        expect_same(*same, *tree);
      }
    }
  }
}

TEST(Build, NoObjectsMakeOneEmptyLeaf) {
  const BoxSet none;
  for (const BuildParams& params : every_way()) {
    SCOPED_TRACE(describe(params));
    const auto tree = build_tree(none.input(), params);
    ASSERT_TRUE(tree.ok());
    EXPECT_EQ(tree->nodes, Nodes{Node::make_leaf(0, 0)});
    EXPECT_TRUE(tree->references.empty());
    EXPECT_TRUE(tree->box.empty());
    expect_valid(none.input(), params);
  }
}

TEST(Build, OneObjectMakesOneLeaf) {
  const BoxSet one({{Vec3(1.0f), Vec3(2.0f)}});
  for (const BuildParams& params : every_way()) {
    SCOPED_TRACE(describe(params));
    const auto tree = build_tree(one.input(), params);
    ASSERT_TRUE(tree.ok());
    EXPECT_EQ(tree->nodes, Nodes{Node::make_leaf(0, 1)});
    EXPECT_EQ(tree->references, References{0});
  }
}

TEST(Build, TheRootBoxIsMovedOutwardsByTheLargestSide) {
  const BoxSet set({{Vec3(0.0f, 1.0f, 2.0f), Vec3(4.0f, 2.0f, 2.0f)}});
  const auto tree = build_tree(set.input(), {});
  ASSERT_TRUE(tree.ok());
  const float margin = 1e-5f * 4.0f;
  EXPECT_EQ(tree->box.lo, Vec3(0.0f - margin, 1.0f - margin, 2.0f - margin));
  EXPECT_EQ(tree->box.hi, Vec3(4.0f + margin, 2.0f + margin, 2.0f + margin));
}

TEST(Build, OnlyTheNaiveTreeIsVisitedBesideItsBox) {
  const BoxSet set = test::random_boxes(100, 1);
  for (const BuildParams& params : every_way()) {
    const auto tree = build_tree(set.input(), params);
    ASSERT_TRUE(tree.ok());
    EXPECT_EQ(tree->naive, params.builder == Builder::naive) << describe(params);
  }
}

TEST(Build, HardCasesEndInValidTrees) {
  BuildParams wishes;
  wishes.memory_limit = std::size_t{1} << 20;
  wishes.max_depth = 1'000'000'000;
  for (const test::HardCase& hard : test::hard_cases(1000, 2)) {
    for (const BuildParams& params : every_way(wishes)) {
      SCOPED_TRACE(hard.name + ", " + describe(params));
      expect_valid(hard.set.input(), params);
    }
  }
}

TEST(Build, StandardScenesMakeValidTrees) {
  for (const SpdScene& spd : spd_scenes()) {
    const auto scene = make_spd(spd.name, spd.has_size ? std::optional(2) : std::nullopt);
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const SceneBuildInput objects(*scene);
    BuildParams wishes;
    wishes.max_depth = 15;
    for (const BuildParams& params : every_way(wishes)) {
      SCOPED_TRACE(std::string(spd.name) + ", " + describe(params));
      expect_valid(objects.input(), params);
    }
  }
}

TEST(Build, ClosedMeshesMakeValidTrees) {
  for (const float offset : {0.0f, 0.1f, 1000.0f, 148376.0f}) {
    const Scene scene = test::cube_grid(6, Vec3(offset));
    const SceneBuildInput objects(scene);
    for (const BuildParams& params : every_way()) {
      SCOPED_TRACE(fmt::format("offset {}, {}", offset, describe(params)));
      expect_valid(objects.input(), params);
    }
  }
}

TEST(Build, NonsenseCostsStillEnd) {
  const BoxSet set = test::random_boxes(300, 5);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float cost : {0.0f, -1.0f, nan, 1e38f}) {
    for (const BuildParams& params : every_way({.max_depth = 12,
                                     .cost_traversal = cost,
                                     .cost_intersection = -cost,
                                     .empty_bonus = cost})) {
      SCOPED_TRACE(fmt::format("cost {}, {}", cost, describe(params)));
      expect_valid(set.input(), params);
    }
  }
}

TEST(Build, TheTreeDoesNotDependOnTheThreads) {
  const BoxSet set = test::random_boxes(6000, 7);
  for (const bool tight : {false, true}) {
    for (BuildParams params : every_way({.max_depth = 14})) {
      if (tight) params.memory_limit = 100'000;
      params.threads = 1;
      const auto serial = build_tree(set.input(), params);
      ASSERT_TRUE(serial.ok());
      for (const int threads : {2, 5, 0}) {
        SCOPED_TRACE(fmt::format("{}, {} threads", describe(params), threads));
        params.threads = threads;
        const auto parallel = build_tree(set.input(), params);
        ASSERT_TRUE(parallel.ok());
        expect_same(*serial, *parallel);
      }
    }
  }
}

TEST(Build, ManyObjectsAreGatheredByAllThreadsInTheirOrder) {
  std::vector<Aabb> boxes = test::random_boxes(40000, 8).boxes();
  for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = Aabb{};
  const BoxSet set(std::move(boxes));
  for (const Builder builder : {Builder::naive, Builder::sah, Builder::sah_binned}) {
    BuildParams params{.builder = builder, .max_depth = 9, .threads = 1};
    const auto serial = build_tree(set.input(), params);
    params.threads = 4;
    const auto parallel = build_tree(set.input(), params);
    ASSERT_TRUE(serial.ok() && parallel.ok());
    expect_same(*serial, *parallel);
    expect_valid(set.input(), params);
  }
}

TEST(Build, SplitsThatDivideNothingAreRefused) {
  const BoxSet set(std::vector<Aabb>(100, {Vec3(0.0f), Vec3(1.0f)}));
  for (const Builder builder :
       {Builder::object_median, Builder::mb, Builder::sah, Builder::sah_binned}) {
    const auto tree = build_tree(set.input(), {.builder = builder});
    ASSERT_TRUE(tree.ok());
    EXPECT_LE(tree->references.size(), set.size()) << name_of(builder);
  }
}

TEST(Build, ClippingNeverAddsReferences) {
  const Scene scene = test::random_scene(600, 9);
  const SceneBuildInput objects(scene);
  for (const Builder builder : {Builder::median, Builder::median_longest}) {
    BuildParams params{.builder = builder, .max_depth = 12, .clip = false};
    const auto boxes = build_tree(objects.input(), params);
    params.clip = true;
    const auto parts = build_tree(objects.input(), params);
    ASSERT_TRUE(boxes.ok() && parts.ok());
    EXPECT_LT(parts->references.size(), boxes->references.size()) << name_of(builder);
  }
}

TEST(Build, WithoutAClipFunctionNothingIsClipped) {
  const BoxSet set = test::random_boxes(500, 10);
  for (const BuildParams& params : every_way({.max_depth = 12})) {
    SCOPED_TRACE(describe(params));
    expect_valid({set.boxes(), nullptr}, params);
  }
}

}  // namespace
}  // namespace bspview
