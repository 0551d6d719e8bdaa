#include "app/viewer/overlays/leaf_mask.h"

#include <gtest/gtest.h>

#include "core/bsp/stats.h"
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

TEST(LeafMask, ChoosesLeavesThatPassTheFilterToo) {
  const Tree tree = small_tree();
  const std::vector<std::uint32_t> nodes{4, 3, 2, no_leaf, 77};
  EXPECT_EQ(choose_leaves(tree, {}, nodes), (Mask{some, none, all, all, all}));
  EXPECT_EQ(choose_leaves(tree, {.contents = LeafFilter::Contents::full}, nodes),
            (Mask{some, none, some, none, all}));
  EXPECT_EQ(choose_leaves(tree, {}, {}), Mask(5, none));
}

TEST(LeafMask, TouchedLeavesAreThoseOnTheSurfaceAndOnTheRays) {
  const Tree tree = small_tree();
  const std::vector<std::uint32_t> surface{4, no_leaf, 4, no_leaf};
  PathRay ray;
  ray.log.steps = {{.node = 0, .kind = StepKind::both}, {.node = 1, .kind = StepKind::leaf}};
  EXPECT_EQ(touched_leaves(tree, surface, {&ray, 1}), (std::vector<std::uint32_t>{1, 4}));
  EXPECT_TRUE(touched_leaves(tree, {}, {}).empty());
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
