#include "tests/support/random_tree.h"

#include <random>

namespace bspview::test {
namespace {

int longest_axis(Vec3 extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

}  // namespace

Tree make_random_tree(int leaves, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(0.25f, 0.75f);
  Tree tree;
  tree.box = {Vec3(0.0f), Vec3(1.0f)};
  tree.nodes.push_back(Node::make_leaf(0, 0));
  std::vector<Aabb> cells{tree.box};
  // Breadth first: the oldest leaf is split next.
  for (int i = 0; i + 1 < leaves; ++i) {
    const Aabb cell = cells[i];
    const int axis = longest_axis(cell.extent());
    const float split = cell.lo[axis] + share(random) * cell.extent()[axis];
    const auto left = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes[i] = Node::make_inner(axis, split, left);
    const Cells children = split_cell(cell, axis, split);
    cells.push_back(children.left);
    cells.push_back(children.right);
    tree.nodes.insert(tree.nodes.end(), 2, Node::make_leaf(0, 0));
  }
  tree.object_count = 8;
  for (Node& node : tree.nodes) {
    if (!node.is_leaf()) continue;
    const std::uint32_t count = random() % 8;
    node = Node::make_leaf(static_cast<std::uint32_t>(tree.references.size()), count);
    for (std::uint32_t object = 0; object < count; ++object) tree.references.push_back(object);
  }
  return tree;
}

}  // namespace bspview::test
