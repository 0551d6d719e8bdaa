#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "core/bsp/build.h"
#include "core/bsp/stats.h"
#include "tests/support/box_sets.h"
#include "tests/support/builds.h"

namespace bspview {
namespace {

using test::BoxSet;
using test::describe;
using test::every_way;
using test::expect_same;
using test::expect_valid;

TEST(BuildLimits, LimitsAreClamped) {
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

TEST(BuildLimits, LeavesHoldAtMostTheLeafSizeWhereTheDepthAllows) {
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

TEST(BuildLimits, ManyHardObjectsStayWithinTheMemoryLimit) {
  BuildParams wishes;
  wishes.memory_limit = std::size_t{1} << 22;
  wishes.max_depth = 1'000'000'000;
  const std::set<std::string> names{"identical", "concentric", "collinear points", "needles"};
  for (const test::HardCase& hard : test::hard_cases(100'000, 3)) {
    if (!names.contains(hard.name)) continue;
    for (wishes.builder = Builder::median; wishes.builder <= Builder::sah_binned;
         wishes.builder = static_cast<Builder>(static_cast<int>(wishes.builder) + 1)) {
      SCOPED_TRACE(hard.name + ", " + describe(wishes));
      const auto tree = build_tree(hard.set.input(), wishes);
      ASSERT_TRUE(tree.ok());
      EXPECT_LE(tree->bytes(), wishes.memory_limit);
      EXPECT_LE(tree_stats(*tree).deepest_leaf, depth_cap);
    }
  }
}

TEST(BuildLimits, ASpentMemoryLimitIsKeptAndSaid) {
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

TEST(BuildLimits, ATreeThatJustFitsIsBuiltWhole) {
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

}  // namespace
}  // namespace bspview
