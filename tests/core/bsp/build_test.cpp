#include "core/bsp/build.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "core/bsp/stats.h"
#include "core/bsp/validate.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/box_sets.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::BoxSet;

std::vector<Builder> every_builder() {
  std::vector<Builder> builders;
  for (std::size_t i = 0; i < builder_names().size(); ++i) {
    builders.push_back(static_cast<Builder>(i));
  }
  return builders;
}

std::string describe(const BuildParams& params) {
  return fmt::format("{}, clip {}", name_of(params.builder), effective_clip(params));
}

/// Every builder, with and without clipping.
std::vector<BuildParams> every_way(BuildParams params = {}) {
  std::vector<BuildParams> ways;
  for (params.builder = Builder::naive; params.builder <= Builder::sah;
       params.builder = static_cast<Builder>(static_cast<int>(params.builder) + 1)) {
    for (const bool clip : {false, true}) {
      params.clip = clip;
      ways.push_back(params);
    }
  }
  return ways;
}

void expect_valid(const BuildInput& input, const BuildParams& params) {
  const auto tree = build_tree(input, params);
  ASSERT_TRUE(tree.ok()) << tree.error().message;
  const auto valid = validate(*tree, input);
  EXPECT_TRUE(valid.ok()) << valid.error().message;
  EXPECT_LE(tree_stats(*tree).deepest_leaf, depth_cap);
}

void expect_same(const Tree& a, const Tree& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.references, b.references);
  EXPECT_EQ(a.memory_limit_reached, b.memory_limit_reached);
}

TEST(Build, NamesFollowTheEnumerators) {
  EXPECT_EQ(name_of(Builder::naive), "naive");
  EXPECT_EQ(name_of(Builder::median), "median");
  EXPECT_EQ(name_of(Builder::median_longest), "median-longest");
  EXPECT_EQ(name_of(Builder::object_median), "object-median");
  EXPECT_EQ(name_of(Builder::mb), "mb");
  EXPECT_EQ(name_of(Builder::sah), "sah");
  EXPECT_EQ(every_builder().back(), Builder::sah);
}

TEST(Build, NoObjectsMakeOneEmptyLeaf) {
  const BoxSet none;
  for (const BuildParams& params : every_way()) {
    SCOPED_TRACE(describe(params));
    const auto tree = build_tree(none.input(), params);
    ASSERT_TRUE(tree.ok());
    EXPECT_EQ(tree->nodes, std::vector{Node::make_leaf(0, 0)});
    EXPECT_TRUE(tree->references.empty());
    EXPECT_TRUE(tree->box.empty());
    EXPECT_TRUE(validate(*tree, none.input()).ok());
  }
}

TEST(Build, OneObjectMakesOneLeaf) {
  const BoxSet one({{Vec3(1.0f), Vec3(2.0f)}});
  for (const BuildParams& params : every_way()) {
    SCOPED_TRACE(describe(params));
    const auto tree = build_tree(one.input(), params);
    ASSERT_TRUE(tree.ok());
    EXPECT_EQ(tree->nodes, std::vector{Node::make_leaf(0, 1)});
    EXPECT_EQ(tree->references, std::vector<std::uint32_t>{0});
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

TEST(Build, ManyHardObjectsStayWithinTheMemoryLimit) {
  BuildParams wishes;
  wishes.memory_limit = std::size_t{1} << 22;
  wishes.max_depth = 1'000'000'000;
  const std::set<std::string> names{"identical", "concentric", "collinear points", "needles"};
  for (const test::HardCase& hard : test::hard_cases(100'000, 3)) {
    if (!names.contains(hard.name)) continue;
    for (wishes.builder = Builder::median; wishes.builder <= Builder::sah;
         wishes.builder = static_cast<Builder>(static_cast<int>(wishes.builder) + 1)) {
      SCOPED_TRACE(hard.name + ", " + describe(wishes));
      const auto tree = build_tree(hard.set.input(), wishes);
      ASSERT_TRUE(tree.ok());
      EXPECT_LE(tree->bytes(), wishes.memory_limit);
      EXPECT_LE(tree_stats(*tree).deepest_leaf, depth_cap);
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

TEST(Build, LimitsAreClamped) {
  const BoxSet set = test::random_boxes(500, 4);
  for (const int depth : {-5, 0}) {
    const auto tree = build_tree(set.input(), {.max_depth = depth});
    ASSERT_TRUE(tree.ok());
    EXPECT_EQ(tree->max_depth, 0);
    EXPECT_EQ(tree->nodes.size(), 1u);
  }
  const auto deep = build_tree(set.input(), {.max_depth = 1'000'000'000});
  ASSERT_TRUE(deep.ok());
  EXPECT_EQ(deep->max_depth, depth_cap);
  const auto one = build_tree(set.input(), {.leaf_size = 1});
  const auto none = build_tree(set.input(), {.leaf_size = -3});
  ASSERT_TRUE(one.ok() && none.ok());
  expect_same(*one, *none);
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

TEST(Build, LeavesHoldAtMostTheLeafSizeWhereTheDepthAllows) {
  const BoxSet set = test::random_boxes(2000, 6);
  for (const int leaf_size : {1, 4, 16}) {
    const auto tree = build_tree(
        set.input(), {.builder = Builder::median, .max_depth = 30, .leaf_size = leaf_size});
    ASSERT_TRUE(tree.ok());
    visit_nodes(*tree, [&](std::uint32_t node, const Aabb&, int depth) {
      const bool small = tree->nodes[node].count() <= static_cast<std::uint32_t>(leaf_size);
      EXPECT_TRUE(!tree->nodes[node].is_leaf() || small || depth == 30);
      return true;
    });
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

TEST(Build, ASpentMemoryLimitIsKeptAndSaid) {
  const BoxSet set = test::random_boxes(3000, 8);
  for (const BuildParams& free : every_way({.max_depth = 14})) {
    const auto whole = build_tree(set.input(), free);
    ASSERT_TRUE(whole.ok());
    EXPECT_FALSE(whole->memory_limit_reached) << describe(free);
    for (const std::size_t limit : {std::size_t{0}, std::size_t{20'000}, whole->bytes() / 2}) {
      SCOPED_TRACE(fmt::format("{}, {} bytes", describe(free), limit));
      BuildParams params = free;
      params.memory_limit = limit;
      expect_valid(set.input(), params);
      const auto tree = build_tree(set.input(), params);
      ASSERT_TRUE(tree.ok());
      if (params.builder == Builder::naive) continue;
      EXPECT_TRUE(tree->memory_limit_reached);
      const std::size_t root_leaf = sizeof(Node) + set.size() * sizeof(std::uint32_t);
      EXPECT_LE(tree->bytes(), std::max(limit, root_leaf));
    }
  }
}

TEST(Build, ATreeThatJustFitsIsBuiltWhole) {
  const BoxSet set = test::random_boxes(3000, 11);
  for (BuildParams params : every_way({.max_depth = 14})) {
    SCOPED_TRACE(describe(params));
    const auto whole = build_tree(set.input(), params);
    ASSERT_TRUE(whole.ok());
    params.memory_limit = whole->bytes();
    const auto fitting = build_tree(set.input(), params);
    ASSERT_TRUE(fitting.ok());
    expect_same(*whole, *fitting);
    if (params.builder == Builder::naive) continue;
    --params.memory_limit;
    const auto cut = build_tree(set.input(), params);
    ASSERT_TRUE(cut.ok());
    EXPECT_TRUE(cut->memory_limit_reached);
    EXPECT_LT(cut->bytes(), whole->bytes());
  }
}

TEST(Build, SplitsThatDivideNothingAreRefused) {
  const BoxSet set(std::vector<Aabb>(100, {Vec3(0.0f), Vec3(1.0f)}));
  for (const Builder builder : {Builder::object_median, Builder::mb, Builder::sah}) {
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
