#include "core/bsp/stats.h"

#include <utility>

#include "core/bsp/cost.h"

namespace bspview {
namespace {

struct NodeInCell {
  std::uint32_t node;
  Aabb cell;
  int depth;
};

void count_up(std::vector<std::uint64_t>& histogram, std::size_t index) {
  if (index >= histogram.size()) histogram.resize(index + 1, 0);
  ++histogram[index];
}

void add_leaf(TreeStats& stats, const NodeInCell& place, std::uint32_t objects) {
  ++stats.leaves;
  stats.references += objects;
  stats.deepest_leaf = std::max(stats.deepest_leaf, place.depth);
  count_up(stats.leaves_at_depth, static_cast<std::size_t>(place.depth));
  count_up(stats.leaves_with_count, objects);
  if (objects == 0) {
    ++stats.empty_leaves;
  } else if (!place.cell.empty()) {
    stats.full_volume += volume(place.cell);
  }
}

/// crossing_probability in the cell of the root, whose area is found once.
class RootCrossing {
 public:
  explicit RootCrossing(const Aabb& root)
      : root_(root), area_(root.empty() ? 0.0 : half_area(root)) {}

  double operator()(const Aabb& cell) const {
    return area_ > 0.0 ? half_area(cell) / area_ : crossing_probability(cell, root_);
  }

 private:
  static double half_area(const Aabb& box) {
    const Vec3d d = Vec3d(box.hi) - Vec3d(box.lo);
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }

  const Aabb root_;
  const double area_;
};

/// visit_nodes for a visitor that can be inlined.
template <class Visit>
class Walk {
 public:
  Walk(const Tree& tree, const Visit& visit) : tree_(tree), visit_(visit), cell_(tree.box) {
    if (!tree.nodes.empty()) descend(0, 0);
  }

 private:
  void descend(std::uint32_t index, int depth) {
    const Node& node = tree_.nodes[index];
    if (!visit_(index, cell_, depth) || node.is_leaf()) return;
    const int axis = node.axis();
    const float hi = std::exchange(cell_.hi[axis], node.split());
    descend(node.left(), depth + 1);
    cell_.hi[axis] = hi;
    const float lo = std::exchange(cell_.lo[axis], node.split());
    descend(node.right(), depth + 1);
    cell_.lo[axis] = lo;
  }

  const Tree& tree_;
  const Visit& visit_;
  Aabb cell_;
};

}  // namespace

TreeStats tree_stats(const Tree& tree, const std::stop_token& stop) {
  constexpr std::uint64_t nodes_between_looks = 1024;
  const CostModel costs = cost_model(tree.params, tree.cost_intersection);
  const RootCrossing crossing(tree.box);
  TreeStats stats;
  stats.volume = tree.box.empty() ? 0.0 : volume(tree.box);
  Walk(tree, [&](std::uint32_t index, const Aabb& cell, int depth) {
    if (stats.nodes % nodes_between_looks == 0 && stop.stop_requested()) return false;
    const Node& node = tree.nodes[index];
    const double probability = crossing(cell);
    ++stats.nodes;
    if (node.is_leaf()) {
      add_leaf(stats, {index, cell, depth}, node.count());
      stats.expected_cost += probability * costs.leaf(node.count());
    } else {
      ++stats.inner;
      stats.expected_cost += probability * costs.traversal;
    }
    return true;
  });
  return stats;
}

void visit_nodes(const Tree& tree, const NodeVisitor& visit) {
  Walk(tree, visit);
}

std::uint32_t find_leaf(const Tree& tree, Vec3 point) {
  if (tree.nodes.empty() || !tree.box.contains(point)) return no_leaf;
  std::uint32_t index = 0;
  while (!tree.nodes[index].is_leaf()) {
    const Node& node = tree.nodes[index];
    index = point[node.axis()] <= node.split() ? node.left() : node.right();
  }
  return index;
}

}  // namespace bspview
