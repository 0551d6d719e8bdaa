#include "app/viewer/overlays/leaf_mask.h"

#include <gtest/gtest.h>

#include "core/bsp/stats.h"
#include "tests/support/random.h"
#include "tests/support/random_tree.h"

namespace bspview {
namespace {

/// Root split into leaf 1 (two objects) and node 2, which is split into leaf 3 (none) and leaf 4
/// (one object).
Tree small_tree() {
  Tree tree;
  tree.box = {Vec3(0.0f), Vec3(1.0f)};
  tree.nodes = {Node::make_inner(0, 0.5f, 1), Node::make_leaf(0, 2), Node::make_inner(1, 0.5f, 3),
                Node::make_leaf(2, 0), Node::make_leaf(2, 1)};
  tree.references = {0, 1, 1};
  tree.object_count = 2;
  tree.max_depth = 2;
  return tree;
}

using Mask = LeafMask;
constexpr Shown none = Shown::none, some = Shown::some, all = Shown::all;

TEST(LeafMask, FiltersByContents) {
  const Tree tree = small_tree();
  EXPECT_EQ(filter_leaves(tree, {}), (Mask{all, all, all, all, all}));
  EXPECT_EQ(filter_leaves(tree, {.contents = LeafFilter::Contents::full}),
            (Mask{some, all, some, none, all}));
  EXPECT_EQ(filter_leaves(tree, {.contents = LeafFilter::Contents::empty}),
            (Mask{some, none, some, all, none}));
}

TEST(LeafMask, FiltersByDepth) {
  const Tree tree = small_tree();
  EXPECT_EQ(filter_leaves(tree, {.max_depth = 1}), (Mask{some, all, none, none, none}));
  EXPECT_EQ(filter_leaves(tree, {.min_depth = 2}), (Mask{some, none, all, all, all}));
  EXPECT_EQ(filter_leaves(tree, {.min_depth = 2, .max_depth = 1}), Mask(5, none));
}

TEST(LeafMask, TouchedLeavesAreThoseOnTheSurfaceAndOnTheRays) {
  const Tree tree = small_tree();
  const NodeCells cells(tree);
  const std::vector<std::uint32_t> surface{4, no_leaf, 4, 2, 77};
  PathRay ray;
  ray.log.steps = {{.node = 0, .kind = StepKind::both}, {.node = 1, .kind = StepKind::leaf}};
  EXPECT_EQ(touched_leaves(cells, {}, surface, {}), (Mask{some, none, some, none, all}));
  EXPECT_EQ(touched_leaves(cells, {}, surface, {&ray, 1}), (Mask{some, all, some, none, all}));
  EXPECT_EQ(touched_leaves(cells, {}, {}, {}), Mask(5, none));
}

TEST(LeafMask, TouchedLeavesPassTheFilterToo) {
  const Tree tree = small_tree();
  const NodeCells cells(tree);
  const std::vector<std::uint32_t> surface{4, 3, 1};
  EXPECT_EQ(touched_leaves(cells, {.contents = LeafFilter::Contents::full}, surface, {}),
            (Mask{some, all, some, none, all}));
  EXPECT_EQ(touched_leaves(cells, {.min_depth = 2}, surface, {}),
            (Mask{some, none, all, all, all}));
}

TEST(LeafMask, LeavesThatAreAllTouchedAreAllOfATree) {
  const Tree tree = test::make_random_tree(400, 2);
  const NodeCells cells(tree);
  test::Random random(3);
  std::vector<std::uint32_t> surface;  // all nodes in any order
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    surface.push_back(i);
    std::swap(surface.back(),
              surface[static_cast<std::size_t>(random.below(static_cast<int>(surface.size())))]);
  }
  for (const LeafFilter& filter : {LeafFilter{},
                                   {.contents = LeafFilter::Contents::empty},
                                   {.min_depth = 5, .max_depth = 9}}) {
    EXPECT_EQ(touched_leaves(cells, filter, surface, {}), filter_leaves(tree, filter));
  }
}

TEST(LeafMask, InnerNodesSayWhatTheirLeavesSay) {
  const Tree tree = test::make_random_tree(400, 2);
  const LeafMask mask = filter_leaves(tree, {.contents = LeafFilter::Contents::full});
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf()) {
      EXPECT_EQ(mask[i], node.count() > 0 ? all : none);
    } else if (mask[i] != some) {
      EXPECT_EQ(mask[node.left()], mask[i]);
      EXPECT_EQ(mask[node.right()], mask[i]);
    }
  }
}

}  // namespace
}  // namespace bspview
