#include "core/bsp/stats.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
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
  Walk(const Tree& tree, const Visit& visit) : Walk(tree, {0, tree.box, 0}, visit) {}
  /// From a node down.
  Walk(const Tree& tree, const NodeInCell& from, const Visit& visit)
      : tree_(tree), visit_(visit), cell_(from.cell) {
    if (!tree.nodes.empty()) descend(from.node, from.depth);
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

void add(std::vector<std::uint64_t>& histogram, const std::vector<std::uint64_t>& more) {
  if (more.size() > histogram.size()) histogram.resize(more.size(), 0);
  for (std::size_t i = 0; i < more.size(); ++i) histogram[i] += more[i];
}

/// All but the volume of the root.
void add(TreeStats& stats, const TreeStats& more) {
  stats.nodes += more.nodes;
  stats.inner += more.inner;
  stats.leaves += more.leaves;
  stats.empty_leaves += more.empty_leaves;
  stats.references += more.references;
  stats.deepest_leaf = std::max(stats.deepest_leaf, more.deepest_leaf);
  stats.full_volume += more.full_volume;
  stats.expected_cost += more.expected_cost;
  add(stats.leaves_at_depth, more.leaves_at_depth);
  add(stats.leaves_with_count, more.leaves_with_count);
}

/// Adds up a tree in parts, the same ones for any number of threads.
class StatsWalk {
 public:
  StatsWalk(const Tree& tree, const std::stop_token& stop)
      : tree_(tree),
        stop_(stop),
        costs_(cost_model(tree.params, tree.cost_intersection)),
        crossing_(tree.box) {}

  /// Of all above `subtrees`, which it finds.
  TreeStats upper_part(std::vector<NodeInCell>& subtrees) const {
    constexpr int upper_depth = 6;
    TreeStats stats;
    Walk(tree_, [&](std::uint32_t index, const Aabb& cell, int depth) {
      if (depth < upper_depth) return add_node(stats, {index, cell, depth});
      subtrees.push_back({index, cell, depth});
      return false;
    });
    return stats;
  }

  TreeStats subtree(const NodeInCell& root) const {
    TreeStats stats;
    Walk(tree_, root, [&](std::uint32_t index, const Aabb& cell, int depth) {
      return add_node(stats, {index, cell, depth});
    });
    return stats;
  }

 private:
  /// False where it is stopped.
  bool add_node(TreeStats& stats, const NodeInCell& place) const {
    constexpr std::uint64_t nodes_between_looks = 1024;
    if (stats.nodes % nodes_between_looks == 0 && stop_.stop_requested()) return false;
    const Node& node = tree_.nodes[place.node];
    const double probability = crossing_(place.cell);
    ++stats.nodes;
    if (node.is_leaf()) {
      add_leaf(stats, place, node.count());
      stats.expected_cost += probability * costs_.leaf(node.count());
    } else {
      ++stats.inner;
      stats.expected_cost += probability * costs_.traversal;
    }
    return true;
  }

  const Tree& tree_;
  const std::stop_token& stop_;
  const CostModel costs_;
  const RootCrossing crossing_;
};

}  // namespace

TreeStats tree_stats(const Tree& tree, const std::stop_token& stop) {
  const StatsWalk walk(tree, stop);
  std::vector<NodeInCell> subtrees;
  TreeStats stats = walk.upper_part(subtrees);
  std::vector<TreeStats> parts(subtrees.size());
  parallel_for(static_cast<int>(parts.size()), [&](int i) {
    const auto part = static_cast<std::size_t>(i);
    parts[part] = walk.subtree(subtrees[part]);
  });
  for (const TreeStats& part : parts) add(stats, part);
  stats.volume = tree.box.empty() ? 0.0 : volume(tree.box);
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
