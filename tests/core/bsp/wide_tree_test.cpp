#include "core/bsp/wide_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/build.h"
#include "core/bsp/grouped_tree.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;

/// Objects that fill their boxes, and are tested eight at once or one by one.
struct Boxes {
  Boxes(std::span<const Aabb> boxes, bool are_eighths) {
    for (const Aabb& box : boxes) list.push_back({box, are_eighths});
  }
  WideObjects objects() const {
    return {list, [this](std::uint32_t object, const Aabb& cell) {
              return intersection(list[object].box, cell);
            }};
  }

  std::vector<WideObject> list;
};

/// A tree over boxes, and its wide form.
struct Wide {
  Wide(std::vector<Aabb> objects, const BuildParams& params, bool are_eighths)
      : boxes(std::move(objects)), tree(*build_tree({boxes, {}}, params)) {
    const Boxes list(boxes, are_eighths);
    Widened widened = *widen(tree, list.objects());
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
      {.builder = Builder::sah, .max_depth = 3},
      {.builder = Builder::sah, .max_depth = 0},  // one leaf, too large to be dealt out to groups
  };
  for (const BuildParams& params : builds) {
    for (const bool are_eighths : {false, true}) {
      const Wide widened(random_boxes(2000, 0.2f, random), params, are_eighths);
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
double cost_at_random(const GroupedTree& tree, std::uint32_t index, Random& random) {
  const GroupedNode& node = tree.nodes[index];
  if (node.is_leaf()) return node.cost[0];
  std::vector<std::uint32_t> cells{node.first, node.other};
  for (int tries = 0; tries < 20 && cells.size() < WideNode::width; ++tries) {
    const auto i = static_cast<std::size_t>(random.between(0.0f, 0.999f) * cells.size());
    const GroupedNode split = tree.nodes[cells[i]];
    if (split.is_leaf()) continue;
    cells[i] = split.first;
    cells.push_back(split.other);
  }
  double cost = tree.area(node.box);
  for (const std::uint32_t cell : cells) cost += cost_at_random(tree, cell, random);
  return cost;
}

/// What testing so many objects alike costs.
double cost_of_tests(std::size_t count, bool are_eighths) {
  ObjectTests tests;
  for (std::size_t i = 0; i < count; ++i) tests.add(are_eighths);
  return tests.cost();
}

/// The same for a wide tree, whose root has the box of the binary one's.
double cost_of(const Wide& wide, double root_area, bool are_eighths) {
  double cost = root_area;
  for (const WideNode& node : wide.wide.nodes) {
    for (int slot = 0; slot < WideNode::width; ++slot) {
      const Aabb box = node.box(slot);
      if (box.empty()) continue;
      const std::uint32_t child = node.child[slot];
      const double steps =
          child & WideNode::leaf_bit
              ? cost_of_tests(wide.leaves[child & ~WideNode::leaf_bit].size(), are_eighths)
              : 1.0;
      cost += half_area(box) * steps;
    }
  }
  return cost;
}

TEST(WideTree, CostsLessThanNodesMadeAtRandom) {
  Random random(7);
  for (const bool are_eighths : {false, true}) {
    const Wide widened(random_boxes(400, 0.2f, random), {}, are_eighths);
    const Boxes boxes(widened.boxes, are_eighths);
    const GroupedTree grouped = group_objects(widened.tree, boxes.objects(), {});
    const GroupedNode& root = grouped.nodes.back();
    const double cost =
        double{grouped.unit} * grouped.unit *
        cost_of(widened, half_area(root.box), are_eighths);
    EXPECT_NEAR(cost, root.cost[0], 1e-4 * cost);
    for (int i = 0; i < 100; ++i) {
      const auto last = static_cast<std::uint32_t>(grouped.nodes.size() - 1);
      ASSERT_LT(cost, cost_at_random(grouped, last, random));
    }
  }
}

/// Steps that a ray which meets the cell of `slot` is expected to take there and below.
double steps_in(const Wide& wide, const WideNode& node, int slot, bool are_eighths) {
  const std::uint32_t child = node.child[slot];
  if (child & WideNode::leaf_bit) {
    return cost_of_tests(wide.leaves[child & ~WideNode::leaf_bit].size(), are_eighths);
  }
  const WideNode& below = wide.wide.nodes[child];
  double steps = 1.0;
  for (int i = 0; i < WideNode::width && !below.box(i).empty(); ++i) {
    const float share = half_area(below.box(i)) / half_area(node.box(slot));
    steps += share * steps_in(wide, below, i, are_eighths);
  }
  return steps;
}

TEST(WideTree, CellsOfMoreStepsComeFirst) {
  Random random(8);
  for (const int max_depth : {5, 30}) {  // with leaves of more steps than nodes, and without
    for (const bool are_eighths : {false, true}) {
      const Wide wide(random_boxes(3000, 0.2f, random), {.max_depth = max_depth}, are_eighths);
      int falls = 0;
      for (const WideNode& node : wide.wide.nodes) {
        double before = std::numeric_limits<double>::infinity();
        for (int slot = 0; slot < WideNode::width && !node.box(slot).empty(); ++slot) {
          const double steps = steps_in(wide, node, slot, are_eighths);
          ASSERT_LE(steps, before * (1.0 + 1e-4));
          falls += slot > 0 && steps < 0.9 * before ? 1 : 0;
          before = steps;
        }
      }
      EXPECT_GT(falls, 10);
    }
  }
}

TEST(WideTree, HoldsEveryObjectOnceBelowABranchOfFewReferences) {
  Random random(3);
  const Wide wide(random_boxes(100, 0.5f, random), {}, true);
  ASSERT_GT(wide.tree.references.size(), 100u);
  ASSERT_LE(wide.tree.references.size(), ObjectGroups::most_objects);
  EXPECT_EQ(wide.leaves.objects.size(), 100u);
  for (std::size_t i = 0; i < wide.leaves.size(); ++i) {
    EXPECT_TRUE(std::ranges::is_sorted(wide.leaves[i]));
  }
}

TEST(WideTree, KeepsCellsAboveBranchesOfFewReferences) {
  Random random(9);
  const Wide wide(random_boxes(4000, 0.2f, random), {}, true);
  const std::size_t repeated = wide.leaves.objects.size() - 4000;
  EXPECT_GT(repeated, 0u);
  EXPECT_LT(repeated, wide.tree.references.size() - 4000);
}

int levels_below(const GroupedTree& tree, std::uint32_t index) {
  const GroupedNode& node = tree.nodes[index];
  if (node.is_leaf()) return 0;
  return 1 + std::max(levels_below(tree, node.first), levels_below(tree, node.other));
}

TEST(WideTree, HasNoMoreLevelsOfGroupsThanAStackHasRoomFor) {
  std::vector<Aabb> boxes;  // each far beyond all before it, so that it is split off alone
  for (int i = -90; i < 90; ++i) {
    const Vec3 corner(std::ldexp(1.0f, i));
    boxes.push_back({corner, 1.01f * corner});
  }
  const Tree tree = *build_tree({boxes, {}}, {.max_depth = 0});
  const Boxes list(boxes, false);
  const GroupedTree grouped = group_objects(tree, list.objects(), {});
  const auto root = static_cast<std::uint32_t>(grouped.nodes.size() - 1);
  EXPECT_EQ(levels_below(grouped, root), ObjectGroups::most_levels);
  EXPECT_EQ(grouped.objects.size(), boxes.size());
}

/// The part of the diagonal of a cube in a cell.
Aabb part_of_diagonal(const Aabb& cube, const Aabb& cell) {
  float first = 0.0f, last = 1.0f;
  const Vec3 size = cube.extent();
  for (int axis = 0; axis < 3; ++axis) {
    first = std::max(first, (cell.lo[axis] - cube.lo[axis]) / size[axis]);
    last = std::min(last, (cell.hi[axis] - cube.lo[axis]) / size[axis]);
  }
  if (first > last) return {};
  return intersection({cube.lo + first * size - 1e-3f, cube.lo + last * size + 1e-3f}, cell);
}

TEST(WideTree, KeepsPlanesWhereGroupsWouldBeDearer) {
  Random random(13);
  std::vector<Aabb> boxes;  // of diagonals that lie side by side, each in the boxes of the others
  for (int i = 0; i < 50; ++i) {
    const Vec3 corner = 0.2f * random.point(1.0f);
    boxes.push_back({corner, corner + 1.0f});
  }
  const auto part = [&](std::uint32_t object, const Aabb& cell) {
    return part_of_diagonal(boxes[object], cell);
  };
  const BuildParams params{.builder = Builder::median, .max_depth = 6, .clip = true};
  const Tree tree = *build_tree({.boxes = boxes, .clip = part}, params);
  ASSERT_GT(tree.references.size(), 200u);
  ASSERT_LE(tree.references.size(), ObjectGroups::most_objects);
  const Boxes list(boxes, false);
  const auto count_objects = [&](const Tree& planes) {
    const WideLeaves leaves = widen(planes, {list.list, part})->leaves;
    std::size_t count = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) count += leaves[i].size();
    return count;
  };
  EXPECT_EQ(count_objects(*build_tree({boxes, {}}, {.max_depth = 0})), boxes.size());
  EXPECT_GT(count_objects(tree), 2 * boxes.size());  // cut by planes
}

TEST(WideTree, LeavesALargeLeafAsItIs) {
  Random random(10);
  const auto boxes = random_boxes(ObjectGroups::most_objects + 1, 0.1f, random);
  const Wide wide(boxes, {.max_depth = 0}, true);
  ASSERT_EQ(wide.leaves.size(), 1u);
  EXPECT_EQ(wide.leaves[0].size(), boxes.size());
}

TEST(WideTree, LeavesAloneWhatIsATreeOfItsOwn) {
  Random random(11);
  const auto boxes = random_boxes(60, 0.01f, random);
  const Tree tree = *build_tree({boxes, {}}, {.cost_intersection = 100.0f});
  Boxes some(boxes, true);
  std::size_t alone = 0;
  for (const Node& node : tree.nodes) {
    if (!node.is_leaf() || node.count() != 1) continue;
    WideObject& object = some.list[tree.objects_of(node)[0]];
    alone += object.is_alone ? 0 : 1;
    object = {object.box, false, true};
  }
  ASSERT_GT(alone, 10u);
  const Widened widened = *widen(tree, some.objects());
  std::size_t found = 0;
  for (std::size_t i = 0; i < widened.leaves.size(); ++i) {
    const auto leaf = widened.leaves[i];
    if (!std::ranges::any_of(leaf, [&](auto id) { return some.list[id].is_alone; })) continue;
    EXPECT_EQ(leaf.size(), 1u);
    ++found;
  }
  EXPECT_GE(found, alone);
}

TEST(WideTree, ShrinksCellsToThePartsOfObjects) {
  Random random(12);
  const auto boxes = random_boxes(200, 0.1f, random);
  const Tree tree = *build_tree({boxes, {}}, {});
  const Boxes list(boxes, true);
  const auto part = [&](std::uint32_t object, const Aabb& cell) {
    const Aabb box = intersection(boxes[object], cell);
    return object % 2 == 0 ? Aabb{} : Aabb{box.lo, box.centre()};
  };
  const Widened widened = *widen(tree, {list.list, part});
  EXPECT_EQ(widened.leaves.objects.size(), 100u);
  Aabb all, parts;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) parts.grow(part(i, tree.box));
  const WideNode& root = widened.tree.nodes[0];
  for (int slot = 0; slot < WideNode::width && !root.box(slot).empty(); ++slot) {
    all.grow(root.box(slot));
  }
  EXPECT_EQ(all, parts);
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
  EXPECT_FALSE(widen(tree, Boxes(boxes, true).objects(), stopper.get_token()));
}

TEST(WideTree, IsTheSameForAnyNumberOfThreads) {
  Random random(5);
  const std::vector<Aabb> boxes = random_boxes(20000, 0.02f, random);
  const Tree tree = *build_tree({boxes, {}}, {});
  const Boxes list(boxes, true);
  const auto bytes = [](const auto& all) { return std::as_bytes(std::span(all)); };
  std::optional<Widened> first;
  for (const int threads : {1, 2, 3, 8}) {
    std::optional<Widened> widened;
    with_threads(threads, [&] { widened = widen(tree, list.objects()); });
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
