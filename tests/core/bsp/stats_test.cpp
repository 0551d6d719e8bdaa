#include "core/bsp/stats.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/parallel.h"
#include "core/bsp/build.h"
#include "tests/support/box_sets.h"
#include "tests/support/random.h"
#include "tests/support/random_tree.h"

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

double area(const Aabb& box) {
  const Vec3d d = Vec3d(box.hi) - Vec3d(box.lo);
  return 2.0 * (d.x * d.y + d.y * d.z + d.z * d.x);
}

/// The statistics, node after node: parents, which come first, make the cells of their children.
TreeStats sum_over_nodes(const Tree& tree) {
  struct Place {
    Aabb cell;
    int depth = 0;
  };
  TreeStats sum;
  sum.volume = volume(tree.box);
  sum.leaves_at_depth.resize(depth_cap + 1);
  sum.leaves_with_count.resize(tree.object_count + 1);
  std::vector<Place> places(tree.nodes.size());
  places[0].cell = tree.box;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    const auto& [cell, depth] = places[i];
    const double share = area(cell) / area(tree.box);
    ++sum.nodes;
    if (node.is_leaf()) {
      ++sum.leaves;
      ++sum.leaves_at_depth[static_cast<std::size_t>(depth)];
      ++sum.leaves_with_count[node.count()];
      sum.references += node.count();
      sum.deepest_leaf = std::max(sum.deepest_leaf, depth);
      sum.expected_cost += share * node.count() * tree.cost_intersection;
      sum.empty_leaves += node.count() == 0 ? 1 : 0;
      sum.full_volume += node.count() == 0 ? 0.0 : volume(cell);
    } else {
      ++sum.inner;
      sum.expected_cost += share * tree.params.cost_traversal;
      const Cells cells = split_cell(cell, node.axis(), node.split());
      const int below = depth + 1;
      places[node.left()] = {cells.left, below};
      places[node.right()] = {cells.right, below};
    }
  }
  return sum;
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

/// The first is so large that other threads wake up before it is added up.
std::vector<Tree> deep_trees() {
  std::vector<Tree> trees{test::make_random_tree(200000, 4)};
  trees.back().cost_intersection = 3.0f;
  for (const Builder builder : {Builder::median, Builder::sah}) {
    const test::BoxSet set = test::random_boxes(5000, 5);
    trees.push_back(*build_tree(set.input(), {.builder = builder, .max_depth = 20}));
  }
  return trees;
}

TEST(Stats, OfADeepTreeAreTheSumOverItsNodes) {
  for (const Tree& tree : deep_trees()) {
    TreeStats sum = sum_over_nodes(tree);
    const TreeStats stats = tree_stats(tree);
    ASSERT_GE(stats.deepest_leaf, 12);
    EXPECT_EQ(stats.nodes, sum.nodes);
    EXPECT_EQ(stats.inner, sum.inner);
    EXPECT_EQ(stats.leaves, sum.leaves);
    EXPECT_EQ(stats.empty_leaves, sum.empty_leaves);
    EXPECT_GT(stats.empty_leaves, 0u);
    EXPECT_EQ(stats.references, sum.references);
    EXPECT_EQ(stats.deepest_leaf, sum.deepest_leaf);
    EXPECT_EQ(stats.volume, sum.volume);
    EXPECT_NEAR(stats.full_volume, sum.full_volume, 1e-10 * sum.full_volume);
    EXPECT_NEAR(stats.expected_cost, sum.expected_cost, 1e-10 * sum.expected_cost);
    sum.leaves_at_depth.resize(stats.leaves_at_depth.size());
    sum.leaves_with_count.resize(stats.leaves_with_count.size());
    EXPECT_EQ(stats.leaves_at_depth, sum.leaves_at_depth);
    EXPECT_EQ(stats.leaves_with_count, sum.leaves_with_count);
  }
}

TEST(Stats, AreTheSameForAnyNumberOfThreads) {
  for (const Tree& tree : deep_trees()) {
    TreeStats alone;
    with_threads(1, [&] { alone = tree_stats(tree); });
    with_threads(4, [&] {
      for (int times = 0; times < 20; ++times) ASSERT_EQ(tree_stats(tree), alone);
    });
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
