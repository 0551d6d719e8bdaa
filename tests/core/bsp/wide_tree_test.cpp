#include "core/bsp/wide_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/bsp/build.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;

/// A tree over boxes, and its wide form with the leaves it asked for.
struct Widened {
  Widened(std::vector<Aabb> objects, const BuildParams& params, bool joins)
      : boxes(std::move(objects)), tree(*build_tree({boxes, {}}, params)) {
    const WideLeaves makers{[&](std::span<const std::uint32_t> ids) {
                              leaves.emplace_back(ids.begin(), ids.end());
                              return static_cast<std::uint32_t>(leaves.size() - 1);
                            },
                            [&](std::uint32_t) { return joins; }};
    wide = *make_wide_tree(tree, boxes, makers);
  }

  /// Whether the wide tree leads to `object` at `point`.
  bool leads_to(std::uint32_t object, Vec3 point, std::uint32_t index = 0) const {
    const WideNode& node = wide.nodes[index];
    for (int slot = 0; slot < WideNode::width; ++slot) {
      if (!box_of(node, slot).contains(point)) continue;
      const std::uint32_t child = node.child[slot];
      if (child & WideNode::leaf_bit) {
        if (std::ranges::count(leaves[child & ~WideNode::leaf_bit], object) > 0) return true;
      } else if (leads_to(object, point, child)) {
        return true;
      }
    }
    return false;
  }

  static Aabb box_of(const WideNode& node, int slot) {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lo[axis] = node.bounds[2 * axis][slot];
      box.hi[axis] = node.bounds[2 * axis + 1][slot];
    }
    return box;
  }

  std::vector<Aabb> boxes;
  Tree tree;
  std::vector<std::vector<std::uint32_t>> leaves;
  WideTree wide;
};

std::vector<Aabb> random_boxes(int count, float size, Random& random) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    Aabb box;
    box.grow(random.point(1.0f));
    box.grow(box.lo + random.point(size));
    boxes.push_back(box);
  }
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
  for (const Builder builder : {Builder::median, Builder::sah}) {
    for (const bool joins : {false, true}) {
      const Widened widened(random_boxes(500, 0.2f, random), {.builder = builder}, joins);
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
  const Widened widened(random_boxes(200, 0.1f, random), {}, true);
  std::size_t used = 0, empty = 0;
  for (const WideNode& node : widened.wide.nodes) {
    for (int slot = 0; slot < WideNode::width; ++slot) {
      (Widened::box_of(node, slot).empty() ? empty : used) += 1;
    }
  }
  EXPECT_EQ(used, widened.leaves.size() + widened.wide.nodes.size() - 1);  // each but the root
  EXPECT_EQ(used + empty, WideNode::width * widened.wide.nodes.size());
}

TEST(WideTree, JoinsLeavesOfFewObjectsOnlyWhereTheyMay) {
  Random random(3);
  const std::vector<Aabb> boxes = random_boxes(300, 0.1f, random);
  const Widened joined(boxes, {}, true), apart(boxes, {}, false);
  EXPECT_LT(joined.leaves.size(), apart.leaves.size());
  std::size_t full = 0, largest = most_joined_objects;
  for (const Node& node : apart.tree.nodes) {
    if (!node.is_leaf() || node.count() == 0) continue;
    ++full;
    largest = std::max<std::size_t>(largest, node.count());
  }
  EXPECT_EQ(apart.leaves.size(), full);
  for (const auto& leaf : joined.leaves) {
    EXPECT_LE(leaf.size(), largest);
    EXPECT_TRUE(std::ranges::is_sorted(leaf));
    EXPECT_EQ(std::ranges::adjacent_find(leaf), leaf.end());
  }
}

TEST(WideTree, OfNothingOrOneThingHasOneNode) {
  const Widened nothing({}, {}, true);
  EXPECT_EQ(nothing.wide.nodes.size(), 1u);
  EXPECT_TRUE(nothing.leaves.empty());
  const Widened one({{Vec3(0.0f), Vec3(1.0f)}}, {}, true);
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
  const WideLeaves makers{[](std::span<const std::uint32_t>) { return 0u; },
                          [](std::uint32_t) { return true; }};
  EXPECT_FALSE(make_wide_tree(tree, boxes, makers, stopper.get_token()));
}

}  // namespace
}  // namespace bspview
