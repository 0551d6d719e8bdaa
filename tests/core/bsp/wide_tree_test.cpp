#include "core/bsp/wide_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/build.h"
#include "core/bsp/joined_tree.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;

/// What a wide tree is made of; every object joins others or none does.
std::vector<WideObject> objects_in(std::span<const Aabb> boxes, bool joins) {
  std::vector<WideObject> objects;
  for (const Aabb& box : boxes) objects.push_back({box, joins});
  return objects;
}

/// A tree over boxes, and its wide form.
struct Wide {
  Wide(std::vector<Aabb> objects, const BuildParams& params, bool joins)
      : boxes(std::move(objects)), tree(*build_tree({boxes, {}}, params)) {
    const std::vector<WideObject> list = objects_in(boxes, joins);
    Widened widened = *widen(tree, list);
    wide = std::move(widened.tree);
    leaves = std::move(widened.leaves);
  }

  /// Whether the wide tree leads to `object` at `point`.
  bool leads_to(std::uint32_t object, Vec3 point, std::uint32_t index = 0) const {
    const WideNode& node = wide.nodes[index];
    for (int slot = 0; slot < WideNode::width; ++slot) {
      if (!node.box(slot).contains(point)) continue;
      const std::uint32_t child = node.child[slot];
      if (child & WideNode::leaf_bit) {
        if (std::ranges::count(leaves[child & ~WideNode::leaf_bit], object) > 0) return true;
      } else if (leads_to(object, point, child)) {
        return true;
      }
    }
    return false;
  }

  std::vector<Aabb> boxes;
  Tree tree;
  WideTree wide;
  WideLeaves leaves;
};

std::vector<Aabb> random_boxes(int count, float size, Random& random) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(random.box(size));
  return boxes;
}

Vec3 point_in(const Aabb& box, Random& random) {
  Vec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] =
        std::clamp(random.between(box.lo[axis], box.hi[axis]), box.lo[axis], box.hi[axis]);
  }
  return point;
}

TEST(WideTree, LeadsToEveryObjectFromEveryPointOfItsBox) {
  Random random(1);
  const BuildParams builds[] = {
      {.builder = Builder::median},
      {.builder = Builder::sah},
      {.builder = Builder::sah, .max_depth = 3},  // leaves whose objects are dealt out to groups
      {.builder = Builder::sah, .max_depth = 0},  // one that is too large for that
  };
  for (const BuildParams& params : builds) {
    for (const bool joins : {false, true}) {
      const Wide widened(random_boxes(500, 0.2f, random), params, joins);
      for (std::uint32_t object = 0; object < widened.boxes.size(); ++object) {
        const Aabb& box = widened.boxes[object];
        for (const Vec3 point : {box.lo, box.hi, point_in(box, random), point_in(box, random)}) {
          ASSERT_TRUE(widened.leads_to(object, point)) << "object " << object;
        }
      }
    }
  }
}

TEST(WideTree, HoldsNothingInSlotsWithoutACell) {
  Random random(2);
  const Wide widened(random_boxes(200, 0.1f, random), {}, true);
  std::size_t used = 0, empty = 0;
  for (const WideNode& node : widened.wide.nodes) {
    for (int slot = 0; slot < WideNode::width; ++slot) {
      (node.box(slot).empty() ? empty : used) += 1;
    }
  }
  EXPECT_EQ(used, widened.leaves.size() + widened.wide.nodes.size() - 1);  // each but the root
  EXPECT_EQ(used + empty, WideNode::width * widened.wide.nodes.size());
}

/// What a ray is expected to cost from a node of the binary tree down, when wide nodes are made
/// of it at random.
double cost_at_random(const JoinedTree& tree, std::uint32_t index, Random& random) {
  const JoinedNode& node = tree.nodes[index];
  if (node.is_leaf()) return node.cost[0];
  std::vector<std::uint32_t> cells{node.first, node.other};
  for (int tries = 0; tries < 20 && cells.size() < WideNode::width; ++tries) {
    const auto i = static_cast<std::size_t>(random.between(0.0f, 0.999f) * cells.size());
    const JoinedNode split = tree.nodes[cells[i]];
    if (split.is_leaf()) continue;
    cells[i] = split.first;
    cells.push_back(split.other);
  }
  double cost = half_area(node.box);
  for (const std::uint32_t cell : cells) cost += cost_at_random(tree, cell, random);
  return cost;
}

/// The same for a wide tree, whose root has the box of the binary one's.
double cost_of(const Wide& wide, double root_area) {
  double cost = root_area;
  for (const WideNode& node : wide.wide.nodes) {
    for (int slot = 0; slot < WideNode::width; ++slot) {
      const Aabb box = node.box(slot);
      if (box.empty()) continue;
      const std::uint32_t child = node.child[slot];
      const std::size_t steps =
          child & WideNode::leaf_bit
              ? (wide.leaves[child & ~WideNode::leaf_bit].size() + most_joined_objects - 1) /
                    most_joined_objects
              : 1;
      cost += static_cast<double>(half_area(box)) * static_cast<double>(steps);
    }
  }
  return cost;
}

TEST(WideTree, CostsLessThanNodesMadeAtRandom) {
  Random random(7);
  for (const bool joins : {false, true}) {
    const Wide widened(random_boxes(400, 0.2f, random), {}, joins);
    const JoinedTree joined = join_leaves(widened.tree, objects_in(widened.boxes, joins), {});
    const JoinedNode& root = joined.nodes.back();
    const double cost = cost_of(widened, half_area(root.box));
    EXPECT_NEAR(cost, root.cost[0], 1e-4 * cost);
    for (int i = 0; i < 100; ++i) {
      const auto last = static_cast<std::uint32_t>(joined.nodes.size() - 1);
      ASSERT_LT(cost, cost_at_random(joined, last, random));
    }
  }
}

/// Steps that a ray which meets the cell of `slot` is expected to take there and below.
double steps_in(const Wide& wide, const WideNode& node, int slot) {
  const std::uint32_t child = node.child[slot];
  if (child & WideNode::leaf_bit) {
    const std::size_t objects = wide.leaves[child & ~WideNode::leaf_bit].size();
    return std::ceil(static_cast<double>(objects) / most_joined_objects);
  }
  const WideNode& below = wide.wide.nodes[child];
  double steps = 1.0;
  for (int i = 0; i < WideNode::width && !below.box(i).empty(); ++i) {
    steps += half_area(below.box(i)) / half_area(node.box(slot)) * steps_in(wide, below, i);
  }
  return steps;
}

TEST(WideTree, CellsOfMoreStepsComeFirst) {
  Random random(8);
  for (const int max_depth : {5, 30}) {  // with leaves of more steps than nodes, and without
    for (const bool joins : {false, true}) {
      const Wide wide(random_boxes(3000, 0.2f, random), {.max_depth = max_depth}, joins);
      int falls = 0;
      for (const WideNode& node : wide.wide.nodes) {
        double before = std::numeric_limits<double>::infinity();
        for (int slot = 0; slot < WideNode::width && !node.box(slot).empty(); ++slot) {
          const double steps = steps_in(wide, node, slot);
          ASSERT_LE(steps, before * (1.0 + 1e-4));
          falls += slot > 0 && steps < 0.9 * before ? 1 : 0;
          before = steps;
        }
      }
      EXPECT_GT(falls, 10);
    }
  }
}

bool is_in_one_leaf(const Tree& tree, std::span<const std::uint32_t> objects) {
  return std::ranges::any_of(tree.nodes, [&](const Node& node) {
    return node.is_leaf() && std::ranges::includes(tree.objects_of(node), objects);
  });
}

TEST(WideTree, JoinsLeavesOfFewObjectsOnlyWhereTheyMay) {
  Random random(3);
  const std::vector<Aabb> boxes = random_boxes(300, 0.1f, random);
  const Wide joined(boxes, {}, true), apart(boxes, {}, false);
  EXPECT_LT(joined.leaves.size(), apart.leaves.size());
  std::size_t largest = most_joined_objects;
  for (const Node& node : apart.tree.nodes) {
    if (node.is_leaf()) largest = std::max<std::size_t>(largest, node.count());
  }
  for (std::size_t i = 0; i < apart.leaves.size(); ++i) {
    EXPECT_TRUE(is_in_one_leaf(apart.tree, apart.leaves[i]));
  }
  EXPECT_EQ(apart.leaves.objects.size(), apart.tree.references.size());
  for (std::size_t i = 0; i < joined.leaves.size(); ++i) {
    const auto leaf = joined.leaves[i];
    EXPECT_LE(leaf.size(), largest);
    EXPECT_TRUE(std::ranges::is_sorted(leaf));
    EXPECT_EQ(std::ranges::adjacent_find(leaf), leaf.end());
  }
}

TEST(WideTree, OfNothingOrOneThingHasOneNode) {
  const Wide nothing({}, {}, true);
  EXPECT_EQ(nothing.wide.nodes.size(), 1u);
  EXPECT_EQ(nothing.leaves.size(), 0u);
  EXPECT_FALSE(nothing.leads_to(0, Vec3(0.0f)));
  const Wide one({{Vec3(0.0f), Vec3(1.0f)}}, {}, true);
  EXPECT_EQ(one.wide.nodes.size(), 1u);
  ASSERT_EQ(one.leaves.size(), 1u);
  EXPECT_TRUE(one.leads_to(0, Vec3(0.5f)));
}

TEST(WideTree, IsNotMadeOnceAStopIsRequested) {
  Random random(4);
  const std::vector<Aabb> boxes = random_boxes(300, 0.1f, random);
  const Tree tree = *build_tree({boxes, {}}, {});
  std::stop_source stopper;
  stopper.request_stop();
  EXPECT_FALSE(widen(tree, objects_in(boxes, true), stopper.get_token()));
}

TEST(WideTree, IsTheSameForAnyNumberOfThreads) {
  Random random(5);
  const std::vector<Aabb> boxes = random_boxes(20000, 0.02f, random);
  const Tree tree = *build_tree({boxes, {}}, {});
  const std::vector<WideObject> objects = objects_in(boxes, true);
  const auto bytes = [](const auto& list) { return std::as_bytes(std::span(list)); };
  std::optional<Widened> first;
  for (const int threads : {1, 2, 3, 8}) {
    std::optional<Widened> widened;
    with_threads(threads, [&] { widened = widen(tree, objects); });
    ASSERT_TRUE(widened);
    if (!first) first = widened;
    EXPECT_TRUE(std::ranges::equal(bytes(first->tree.nodes), bytes(widened->tree.nodes)));
    EXPECT_TRUE(std::ranges::equal(bytes(first->leaves.ranges), bytes(widened->leaves.ranges)));
    EXPECT_EQ(first->leaves.objects, widened->leaves.objects);
  }
}

TEST(WideTree, LiesDepthFirstInMemory) {
  Random random(6);
  const Wide wide(random_boxes(20000, 0.02f, random), {}, true);
  std::uint32_t nodes = 0, leaves = 0;
  const auto visit = [&](const auto& self, std::uint32_t child) -> void {
    if (child & WideNode::leaf_bit) {
      ASSERT_EQ(child & ~WideNode::leaf_bit, leaves++);
      return;
    }
    ASSERT_EQ(child, nodes++);
    const WideNode& node = wide.wide.nodes[child];
    for (int slot = 0; slot < WideNode::width; ++slot) {
      if (!node.box(slot).empty()) self(self, node.child[slot]);
    }
  };
  visit(visit, 0);
  EXPECT_EQ(nodes, wide.wide.nodes.size());
  EXPECT_EQ(leaves, wide.leaves.size());
}

}  // namespace
}  // namespace bspview
