#include "app/viewer/overlays/node_boxes.h"

#include <algorithm>

#include "app/viewer/overlays/rgba.h"

namespace bspview {
namespace {

/// Per node: the greatest value of the leaves below it. Parents come before their children.
std::vector<std::uint32_t> greatest_values(const Tree& tree, LeafColor color_by) {
  std::vector<std::uint32_t> values(tree.nodes.size(), 0);
  const bool by_depth = color_by == LeafColor::depth;
  for (std::size_t i = 0; by_depth && i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (!node.is_leaf()) values[node.left()] = values[node.right()] = values[i] + 1;
  }
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    if (!node.is_leaf()) {
      values[i] = std::max(values[node.left()], values[node.right()]);
    } else if (!by_depth) {
      values[i] = node.count();
    }
  }
  return values;
}

std::uint32_t value_color(const NodeBoxStyle& style, std::uint32_t value) {
  const float position = position_on(style.scale, static_cast<float>(value));
  return pack_color(color_at(style.scale, position), style.alpha);
}

constexpr std::uint32_t table_size = 1024;  // greater values are rare

/// Index: value of a leaf.
std::vector<std::uint32_t> value_colors(const NodeBoxStyle& style) {
  std::vector<std::uint32_t> colors(table_size);
  for (std::uint32_t value = 0; value < table_size; ++value) {
    colors[value] = value_color(style, value);
  }
  return colors;
}

/// A node with its cell.
struct Subtree {
  std::uint32_t node;
  Aabb cell;
};

/// An edge parallel to `axis`.
struct Edge {
  int axis;
  Vec3 from;
  float end;  ///< coordinate on the axis

  Vec3 to() const {
    Vec3 point = from;
    point[axis] = end;
    return point;
  }
};

class BoxLines {
 public:
  BoxLines(const Tree& tree, const LeafMask& shown, const NodeBoxStyle& style,
           const BoxPruning* pruning)
      : tree_(tree), shown_(shown), style_(style), pruning_(pruning) {
    if (style.color_by == LeafColor::plain) return;
    values_ = greatest_values(tree, style.color_by);
    colors_ = value_colors(style);
  }

  /// Draws the boxes of the shown leaves below.
  void draw(const Subtree& subtree, const std::stop_token& stop) {
    if (shown_[subtree.node] == Shown::none || stop.stop_requested()) return;
    const OnScreen on_screen = place(subtree.cell);
    if (on_screen == OnScreen::outside) return;
    if (shown_[subtree.node] == Shown::all || on_screen == OnScreen::small) {
      draw_box(subtree);
      draw_splits(subtree, stop);
      return;
    }
    const auto [left, right] = children(subtree);
    draw(left, stop);
    draw(right, stop);
  }

  LineList take() { return std::move(lines_); }

 private:
  OnScreen place(const Aabb& cell) const {
    return pruning_ ? find_on_screen(*pruning_, cell) : OnScreen::large;
  }

  std::pair<Subtree, Subtree> children(const Subtree& parent) const {
    const Node& node = tree_.nodes[parent.node];
    const Cells cells = split_cell(parent.cell, node.axis(), node.split());
    return {{node.left(), cells.left}, {node.right(), cells.right}};
  }

  void draw_box(const Subtree& subtree) {
    for_box_edges(subtree.cell, [&](int axis, Vec3 from) {
      draw_edge({axis, from, subtree.cell.hi[axis]}, subtree.node, subtree.node);
    });
  }

  /// The split rectangles of the subtree.
  void draw_splits(const Subtree& subtree, const std::stop_token& stop) {
    const Node& node = tree_.nodes[subtree.node];
    if (node.is_leaf() || stop.stop_requested()) return;
    if (place(subtree.cell) != OnScreen::large) return;
    const auto [left, right] = children(subtree);
    draw_rectangle(left.cell, node);
    draw_splits(left, stop);
    draw_splits(right, stop);
  }

  /// The edges of the upper face of the left child of `node`.
  void draw_rectangle(const Aabb& left_cell, const Node& node) {
    const auto& [lo, hi] = left_cell;
    for (int i = 1; i <= 2; ++i) {
      const int along = (node.axis() + i) % 3, across = (node.axis() + 3 - i) % 3;
      Vec3 from = lo;
      from[node.axis()] = node.split();
      draw_edge({along, from, hi[along]}, node.left(), node.right());
      from[across] = hi[across];
      draw_edge({along, from, hi[along]}, node.left(), node.right());
    }
  }

  /// `a` and `b` are the nodes on both sides that have the edge.
  void draw_edge(const Edge& edge, std::uint32_t a, std::uint32_t b) {
    if (style_.color_by == LeafColor::plain) {
      lines_.push_back({edge.from, edge.to(), style_.plain, style_.width});
      return;
    }
    first_of_edge_ = lines_.size();
    draw_pieces(edge, a, b);
  }

  /// Follows the edge down the trees of both nodes to the leaves that have a piece of it.
  void draw_pieces(const Edge& edge, std::uint32_t a, std::uint32_t b) {
    const bool whole = pruning_ && is_short(*pruning_, edge.from, edge.to());
    const std::uint32_t inner = tree_.nodes[a].is_leaf() ? b : a;
    const Node& node = tree_.nodes[inner];
    if (whole || node.is_leaf()) {
      add_piece(edge, std::max(values_[a], values_[b]));
      return;
    }
    const auto with = [&](const Edge& piece, std::uint32_t child) {
      draw_pieces(piece, inner == a ? child : a, inner == a ? b : child);
    };
    const float split = node.split(), start = edge.from[node.axis()];
    if (node.axis() != edge.axis || split <= start || split >= edge.end) {
      with(edge, start < split ? node.left() : node.right());
      return;
    }
    Edge lower = edge, upper = edge;
    lower.end = upper.from[edge.axis] = split;
    with(lower, node.left());
    with(upper, node.right());
  }

  std::uint32_t color_of(std::uint32_t value) const {
    return value < table_size ? colors_[value] : value_color(style_, value);
  }

  /// Pieces of one edge come in order, so equal neighbours grow together.
  void add_piece(const Edge& piece, std::uint32_t value) {
    const std::uint32_t color = color_of(value);
    if (lines_.size() > first_of_edge_ && lines_.back().color == color) {
      lines_.back().to = piece.to();
    } else {
      lines_.push_back({piece.from, piece.to(), color, style_.width});
    }
  }

  const Tree& tree_;
  const LeafMask& shown_;
  const NodeBoxStyle& style_;
  const BoxPruning* pruning_;
  std::vector<std::uint32_t> values_;  // as greatest_values; empty when plain
  std::vector<std::uint32_t> colors_;  // as value_colors; empty when plain
  std::size_t first_of_edge_ = 0;      // index into lines_
  LineList lines_;
};

}  // namespace

ColorScale leaf_color_scale(const TreeStats& stats, LeafColor color_by, ColorMap map) {
  if (color_by == LeafColor::depth) {
    return {map, 0.0f, static_cast<float>(stats.deepest_leaf), ColorScale::Spacing::linear};
  }
  const std::size_t counts = std::max<std::size_t>(stats.leaves_with_count.size(), 1);
  return {map, 0.0f, static_cast<float>(counts - 1), ColorScale::Spacing::logarithmic};
}

LineList node_box_lines(const Tree& tree, const LeafMask& shown, const NodeBoxStyle& style,
                        const std::optional<BoxPruning>& pruning, std::stop_token stop) {
  if (tree.nodes.empty() || tree.box.empty()) return {};
  BoxLines lines(tree, shown, style, pruning ? &*pruning : nullptr);
  lines.draw({0, tree.box}, stop);
  return lines.take();
}

}  // namespace bspview
