#include "app/viewer/overlays/node_cells.h"

#include <gtest/gtest.h>

#include "core/bsp/stats.h"
#include "tests/support/random_tree.h"

namespace bspview {
namespace {

TEST(NodeCells, EveryNodeHasTheCellAndDepthThatAWalkFromTheRootFinds) {
  const Tree tree = test::make_random_tree(300, 8);
  const NodeCells cells(tree);
  visit_nodes(tree, [&](std::uint32_t node, const Aabb& cell, int depth) {
    EXPECT_EQ(cells.cell(node), cell) << node;
    EXPECT_EQ(cells.depth(node), depth) << node;
    return true;
  });
}

TEST(NodeCells, APathLeadsFromTheRootToTheNode) {
  const Tree tree = test::make_random_tree(50, 8);
  const NodeCells cells(tree);
  const auto last = static_cast<std::uint32_t>(tree.nodes.size() - 1);
  const std::vector<std::uint32_t> path = cells.path(last);
  EXPECT_EQ(path.front(), 0u);
  EXPECT_EQ(path.back(), last);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Node& node = tree.nodes[path[i]];
    EXPECT_TRUE(path[i + 1] == node.left() || path[i + 1] == node.right());
  }
  EXPECT_EQ(cells.path(0), std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace bspview
