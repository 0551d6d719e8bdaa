#include "core/bsp/stats.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/bsp/cost.h"

namespace bspview {
namespace {

/// The cell of a node as a walk goes down, with what all of its nodes need: the lengths of its
/// sides, in double.
struct SizedCell {
  explicit SizedCell(const Aabb& box)
      : cell(box), size(box.empty() ? Vec3d(0.0) : Vec3d(box.hi) - Vec3d(box.lo)) {}

  double half_area() const { return size.x * size.y + size.y * size.z + size.z * size.x; }
  double volume() const { return size.x * size.y * size.z; }

  Aabb cell;
  Vec3d size;
};

struct NodeInCell {
  std::uint32_t node;
  SizedCell cell;
  int depth;
};

void count_up(std::vector<std::uint64_t>& histogram, std::size_t index) {
  if (index >= histogram.size()) histogram.resize(index + 1, 0);
  ++histogram[index];
}

void add_leaf(TreeStats& stats, const SizedCell& cell, int depth, std::uint32_t objects) {
  ++stats.leaves;
  stats.references += objects;
  count_up(stats.leaves_at_depth, static_cast<std::size_t>(depth));
  count_up(stats.leaves_with_count, objects);
  stats.empty_leaves += objects == 0;
  stats.full_volume += objects == 0 ? 0.0 : cell.volume();
}

/// crossing_probability in the cell of the root, whose area is found once.
class RootCrossing {
 public:
  explicit RootCrossing(const Aabb& root) : root_(root), area_(SizedCell(root).half_area()) {}

  double operator()(const SizedCell& cell) const {
    return area_ > 0.0 ? cell.half_area() / area_ : crossing_probability(cell.cell, root_);
  }

 private:
  const Aabb root_;
  const double area_;
};

/// visit_nodes for a visitor that can be inlined.
template <class Visit>
class Walk {
 public:
  Walk(const Tree& tree, const Visit& visit) : Walk(tree, {0, SizedCell(tree.box), 0}, visit) {}
  /// From a node down.
  Walk(const Tree& tree, const NodeInCell& from, const Visit& visit)
      : nodes_(tree.nodes.data()), visit_(visit), at_(from.cell) {
    if (!tree.nodes.empty()) descend(from.node, from.depth);
  }

 private:
  void descend(std::uint32_t index, int depth) {
    const Node node = nodes_[index];
    if (!visit_(index, at_, depth) || node.is_leaf()) return;
    const int axis = node.axis();
    const float split = node.split();
    const double size = at_.size[axis];
    const float hi = std::exchange(at_.cell.hi[axis], split);
    at_.size[axis] = double{split} - double{at_.cell.lo[axis]};
    descend(node.left(), depth + 1);
    at_.cell.hi[axis] = hi;
    const float lo = std::exchange(at_.cell.lo[axis], split);
    at_.size[axis] = double{hi} - double{split};
    descend(node.right(), depth + 1);
    at_.cell.lo[axis] = lo;
    at_.size[axis] = size;
  }

  const Node* const nodes_;
  const Visit& visit_;
  SizedCell at_;
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
    Walk(tree_, [&](std::uint32_t index, const SizedCell& cell, int depth) {
      if (depth < upper_depth) return add_node(stats, index, cell, depth);
      subtrees.push_back({index, cell, depth});
      return false;
    });
    return stats;
  }

  TreeStats subtree(const NodeInCell& root) const {
    TreeStats stats;
    Walk(tree_, root, [&](std::uint32_t index, const SizedCell& cell, int depth) {
      return add_node(stats, index, cell, depth);
    });
    return stats;
  }

 private:
  /// False where it is stopped.
  bool add_node(TreeStats& stats, std::uint32_t index, const SizedCell& cell, int depth) const {
    constexpr std::uint64_t nodes_between_looks = 1024;
    if (stats.nodes % nodes_between_looks == 0 && stop_.stop_requested()) return false;
    const Node& node = tree_.nodes[index];
    const double probability = crossing_(cell);
    ++stats.nodes;
    if (node.is_leaf()) {
      add_leaf(stats, cell, depth, node.count());
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
  stats.deepest_leaf = std::max(0, static_cast<int>(stats.leaves_at_depth.size()) - 1);
  stats.volume = tree.box.empty() ? 0.0 : volume(tree.box);
  return stats;
}

void visit_nodes(const Tree& tree, const NodeVisitor& visit) {
  Walk(tree, [&](std::uint32_t index, const SizedCell& cell, int depth) {
    return visit(index, cell.cell, depth);
  });
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
