#include "core/bsp/stats.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/bsp/build.h"
#include "tests/support/box_sets.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

/// A cube of side 4, halved at x = 2, its right half cut at y = 1: leaves 1 (two objects),
/// 3 (empty) and 4 (one object).
Tree small_tree() {
  Tree tree;
  tree.box = {Vec3(0.0f), Vec3(4.0f)};
  tree.nodes = {Node::make_inner(0, 2.0f, 1), Node::make_leaf(0, 2), Node::make_inner(1, 1.0f, 3),
                Node::make_leaf(2, 0), Node::make_leaf(2, 1)};
  tree.references = {0, 1, 1};
  tree.object_count = 2;
  tree.params.cost_traversal = 1.0f;
  tree.cost_intersection = 10.0f;
  return tree;
}

TEST(Stats, CountsNodesReferencesAndVolumes) {
  const TreeStats stats = tree_stats(small_tree());
  EXPECT_EQ(stats.nodes, 5u);
  EXPECT_EQ(stats.inner, 2u);
  EXPECT_EQ(stats.leaves, 3u);
  EXPECT_EQ(stats.empty_leaves, 1u);
  EXPECT_EQ(stats.references, 3u);
  EXPECT_EQ(stats.deepest_leaf, 2);
  EXPECT_EQ(stats.volume, 64.0);
  EXPECT_EQ(stats.full_volume, 32.0 + 24.0);
  EXPECT_EQ(stats.leaves_at_depth, (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_EQ(stats.leaves_with_count, (std::vector<std::uint64_t>{1, 1, 1}));
}

TEST(Stats, ExpectedCostWeighsNodesByTheirArea) {
  // Half areas: root 48, halves 32, leaf 4 (2 x 3 x 4) 26.
  const double expected = 1.0 + 32.0 / 48.0 * 20.0 + 32.0 / 48.0 * 1.0 + 26.0 / 48.0 * 10.0;
  EXPECT_NEAR(tree_stats(small_tree()).expected_cost, expected, 1e-12);
}

TEST(Stats, AStopEndsTheCount) {
  std::stop_source stop;
  EXPECT_EQ(tree_stats(small_tree(), stop.get_token()), tree_stats(small_tree()));
  stop.request_stop();
  EXPECT_EQ(tree_stats(small_tree(), stop.get_token()).nodes, 0u);
}

TEST(Stats, ATreeWithoutObjectsHasNoVolume) {
  const auto tree = build_tree({}, {});
  ASSERT_TRUE(tree.ok());
  const TreeStats stats = tree_stats(*tree);
  EXPECT_EQ(stats.leaves, 1u);
  EXPECT_EQ(stats.empty_leaves, 1u);
  EXPECT_EQ(stats.volume, 0.0);
  EXPECT_EQ(stats.full_volume, 0.0);
  EXPECT_EQ(stats.expected_cost, 0.0);
}

TEST(Stats, HistogramsAddUpToTheLeaves) {
  const test::BoxSet set = test::random_boxes(2000, 1);
  for (const Builder builder : {Builder::median, Builder::sah}) {
    const auto tree = build_tree(set.input(), {.builder = builder, .max_depth = 12});
    ASSERT_TRUE(tree.ok());
    const TreeStats stats = tree_stats(*tree);
    const auto sum = [](const std::vector<std::uint64_t>& histogram) {
      return std::accumulate(histogram.begin(), histogram.end(), std::uint64_t{0});
    };
    EXPECT_EQ(sum(stats.leaves_at_depth), stats.leaves);
    EXPECT_EQ(sum(stats.leaves_with_count), stats.leaves);
    EXPECT_EQ(stats.leaves_at_depth.size(), static_cast<std::size_t>(stats.deepest_leaf) + 1);
    EXPECT_EQ(stats.leaves_with_count[0], stats.empty_leaves);
    EXPECT_EQ(stats.references, tree->references.size());
    EXPECT_EQ(stats.nodes, tree->nodes.size());
    EXPECT_EQ(stats.leaves, stats.inner + 1);
  }
}

TEST(Stats, VisitsParentsFirstAndLeavesOutWhatIsNotWanted) {
  const Tree tree = small_tree();
  std::vector<std::uint32_t> all, shallow;
  visit_nodes(tree, [&](std::uint32_t node, const Aabb&, int) {
    all.push_back(node);
    return true;
  });
  visit_nodes(tree, [&](std::uint32_t node, const Aabb&, int depth) {
    shallow.push_back(node);
    return depth < 1;
  });
  EXPECT_EQ(all, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(shallow, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Stats, FindsTheLeafOfAPointAndPutsPlanesToTheLeft) {
  const Tree tree = small_tree();
  EXPECT_EQ(find_leaf(tree, Vec3(1.0f)), 1u);
  EXPECT_EQ(find_leaf(tree, Vec3(2.0f, 0.0f, 0.0f)), 1u);
  EXPECT_EQ(find_leaf(tree, Vec3(3.0f, 1.0f, 2.0f)), 3u);
  EXPECT_EQ(find_leaf(tree, Vec3(4.0f)), 4u);
  EXPECT_EQ(find_leaf(tree, Vec3(4.1f, 1.0f, 1.0f)), no_leaf);
  EXPECT_EQ(find_leaf(tree, Vec3(std::numeric_limits<float>::quiet_NaN())), no_leaf);
  EXPECT_EQ(find_leaf(Tree{}, Vec3(0.0f)), no_leaf);
}

TEST(Stats, TheLeafOfAPointHasACellThatHoldsIt) {
  const test::BoxSet set = test::random_boxes(1000, 2);
  const auto tree = build_tree(set.input(), {});
  ASSERT_TRUE(tree.ok());
  std::vector<Aabb> cells(tree->nodes.size());
  visit_nodes(*tree, [&](std::uint32_t node, const Aabb& cell, int) {
    cells[node] = cell;
    return true;
  });
  test::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = random.point(1.0f);
    const std::uint32_t leaf = find_leaf(*tree, point);
    ASSERT_NE(leaf, no_leaf);
    EXPECT_TRUE(tree->nodes[leaf].is_leaf());
    EXPECT_TRUE(cells[leaf].contains(point));
  }
}

}  // namespace
}  // namespace bspview
