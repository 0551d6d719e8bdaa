#include "core/bsp/wide_tree.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/grouped_tree.h"

namespace bspview {
namespace {

/// The cells that a node of the binary tree is replaced by: those of the least expected cost.
class NodeCells {
 public:
  NodeCells(const GroupedTree& tree, std::uint32_t index) : tree_(tree) {
    if (tree.nodes[index].is_leaf()) {
      nodes_[size_++] = index;
    } else {
      add_below(index, WideNode::width);
    }
    sort_by_steps();
  }

  int size() const { return size_; }
  /// Indices in the binary tree.
  std::uint32_t operator[](int i) const { return nodes_[i]; }

 private:
  /// Packets that any hit will do visit the last cells first, which have the fewest steps below
  /// them: what blocks rays is found sooner there than in the nearest.
  void sort_by_steps() {
    const auto steps = [&](std::uint32_t cell) {
      const GroupedNode& node = tree_.nodes[cell];
      return node.cost[0] / std::max(tree_.area(node.box), 0x1p-120f);
    };
    std::ranges::stable_sort(std::span(nodes_).first(static_cast<std::size_t>(size_)),
                             std::greater{}, steps);
  }

  void add(std::uint32_t index, int cells) {
    const GroupedNode& node = tree_.nodes[index];
    while (cells > 1 && node.cost[cells - 2] == node.cost[cells - 1]) --cells;
    if (cells > 1 && !node.is_leaf()) {
      add_below(index, cells);
    } else {
      nodes_[size_++] = index;
    }
  }
  void add_below(std::uint32_t index, int cells) {
    const GroupedNode& node = tree_.nodes[index];
    const int left = share_cells(tree_.nodes[node.first], tree_.nodes[node.other], cells).left;
    add(node.first, left);
    add(node.other, cells - left);
  }

  const GroupedTree& tree_;
  std::uint32_t nodes_[WideNode::width];
  int size_ = 0;
};

bool is_used(const WideNode& node, int slot) {
  return node.bounds[0][slot] <= node.bounds[1][slot];
}

/// A node with nothing but the bounds of its cells.
WideNode make_node(const GroupedTree& tree, const NodeCells& cells) {
  WideNode node = WideNode::without_cells();
  for (int slot = 0; slot < cells.size(); ++slot) {
    node.set_bounds(slot, tree.nodes[cells[slot]].box);
  }
  return node;
}

/// A branch of the wide tree, counted from 0, for one thread to make; or a node near the root.
struct Piece {
  std::uint32_t root = 0;  ///< in the binary tree
  bool is_lone = false;    ///< one node, whose children are the numbers of pieces
  std::vector<WideNode> nodes;
  std::vector<WideLeaves::Range> leaves;
  std::uint32_t first_node = 0, first_leaf = 0;  ///< in the whole
  std::uint32_t name = 0;                        ///< of the child that leads to it
};

class PieceMaker {
 public:
  PieceMaker(const GroupedTree& tree, const std::stop_token& stop, Piece& piece)
      : tree_(tree), stop_(stop), piece_(piece) {}

  /// Answers the child.
  std::uint32_t make(std::uint32_t index) {
    if (tree_.nodes[index].is_leaf()) return make_leaf(tree_.nodes[index]);
    const auto place = static_cast<std::uint32_t>(piece_.nodes.size());
    if (stop_.stop_requested()) return place;
    const NodeCells cells(tree_, index);
    piece_.nodes.push_back(make_node(tree_, cells));
    for (int slot = 0; slot < cells.size(); ++slot) {
      const std::uint32_t child = make(cells[slot]);
      piece_.nodes[place].child[slot] = child;
    }
    return place;
  }

 private:
  std::uint32_t make_leaf(const GroupedNode& leaf) {
    piece_.leaves.push_back({leaf.first, leaf.other});
    return WideNode::leaf_bit | static_cast<std::uint32_t>(piece_.leaves.size() - 1);
  }

  const GroupedTree& tree_;
  const std::stop_token& stop_;
  Piece& piece_;
};

/// Plans the pieces, makes them and puts them together, depth first all along.
class Widener {
 public:
  Widener(const GroupedTree& tree, const std::stop_token& stop) : tree_(tree), stop_(stop) {
    constexpr std::uint32_t worth_a_piece = 512, most_pieces = 256;  // about
    if (!tree.nodes.empty()) {
      most_inner_ = std::max(worth_a_piece, tree.nodes.back().inner / most_pieces);
    }
  }

  std::optional<Widened> widen() {
    plan_root();
    for_each_piece([&](Piece& piece) {
      if (!piece.is_lone) PieceMaker(tree_, stop_, piece).make(piece.root);
    });
    if (stop_.stop_requested()) return {};
    place();
    for_each_piece([&](Piece& piece) { move_in(piece); });
    if (stop_.stop_requested()) return {};
    return std::move(widened_);
  }

 private:
  void plan_root() {
    if (!tree_.nodes.empty()) {
      plan_lone(static_cast<std::uint32_t>(tree_.nodes.size() - 1));
    } else {
      pieces_.push_back({.is_lone = true, .nodes = {WideNode::without_cells()}});
    }
  }

  std::uint32_t plan(std::uint32_t index) {
    if (tree_.nodes[index].inner > most_inner_) return plan_lone(index);
    pieces_.emplace_back().root = index;
    return static_cast<std::uint32_t>(pieces_.size() - 1);
  }

  /// Answers the number of the piece.
  std::uint32_t plan_lone(std::uint32_t index) {
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    pieces_.emplace_back().is_lone = true;
    const NodeCells cells(tree_, index);
    WideNode node = make_node(tree_, cells);
    for (int slot = 0; slot < cells.size(); ++slot) node.child[slot] = plan(cells[slot]);
    pieces_[number].nodes.push_back(node);
    return number;
  }

  template <class Work>
  void for_each_piece(const Work& work) {
    parallel_for(static_cast<int>(pieces_.size()), [&](int i) {
      if (!stop_.stop_requested()) work(pieces_[static_cast<std::size_t>(i)]);
    });
  }

  void place() {
    std::size_t nodes = 0, leaves = 0;
    for (Piece& piece : pieces_) {
      piece.first_node = static_cast<std::uint32_t>(nodes);
      piece.first_leaf = static_cast<std::uint32_t>(leaves);
      piece.name = piece.nodes.empty() ? WideNode::leaf_bit | piece.first_leaf : piece.first_node;
      nodes += piece.nodes.size();
      leaves += piece.leaves.size();
    }
    widened_.tree.nodes.resize(nodes);
    widened_.leaves.ranges.resize(leaves);
  }

  void move_in(Piece& piece) {
    WideNode* to = widened_.tree.nodes.data() + piece.first_node;
    for (WideNode node : piece.nodes) {
      for (int slot = 0; slot < WideNode::width && is_used(node, slot); ++slot) {
        node.child[slot] = moved(piece, node.child[slot]);
      }
      *to++ = node;
    }
    std::ranges::copy(piece.leaves, widened_.leaves.ranges.data() + piece.first_leaf);
    piece.nodes = {};
    piece.leaves = {};
  }

  std::uint32_t moved(const Piece& piece, std::uint32_t child) const {
    if (piece.is_lone) return pieces_[child].name;
    return child + (child & WideNode::leaf_bit ? piece.first_leaf : piece.first_node);
  }

  const GroupedTree& tree_;
  const std::stop_token& stop_;
  std::uint32_t most_inner_ = 0;  // nodes of the binary tree below a piece
  std::vector<Piece> pieces_;
  Widened widened_;
};

}  // namespace

std::optional<Widened> widen(const Tree& tree, const WideObjects& objects, std::stop_token stop) {
  GroupedTree grouped = group_objects(tree, objects, stop);
  if (stop.stop_requested()) return {};
  std::optional<Widened> widened = Widener(grouped, stop).widen();
  if (widened) widened->leaves.objects = std::move(grouped.objects);
  return widened;
}

}  // namespace bspview
