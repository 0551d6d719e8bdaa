#include "app/viewer/overlays/edge_lines.h"

#include <algorithm>

namespace bspview {
namespace {

class EdgeWalk {
 public:
  EdgeWalk(LineList& lines, const EdgeLook& look)
      : lines_(lines), look_(look), first_(lines.size()) {}

  /// Follows the edge down the trees of both nodes to the leaves that have a piece of it.
  void walk(const Edge& edge, EdgeNodes nodes) {
    const Nodes& all = look_.tree.nodes;
    const bool on_a = !all[nodes.a].is_leaf();
    const Node& node = all[on_a ? nodes.a : nodes.b];
    if (node.is_leaf() || is_one_piece(edge)) {
      add_piece(edge, std::max(look_.colors.value(nodes.a), look_.colors.value(nodes.b)));
      return;
    }
    const auto below = [&](std::uint32_t child) {
      return on_a ? EdgeNodes{child, nodes.b} : EdgeNodes{nodes.a, child};
    };
    const float split = node.split(), start = edge.from[node.axis()];
    if (node.axis() != edge.axis || split <= start || split >= edge.end) {
      walk(edge, below(start < split ? node.left() : node.right()));
      return;
    }
    Edge lower = edge, upper = edge;
    lower.end = upper.from[edge.axis] = split;
    walk(lower, below(node.left()));
    walk(upper, below(node.right()));
  }

 private:
  bool is_one_piece(const Edge& edge) const {
    return look_.colors.plain() ||
           (look_.pruning && is_short(*look_.pruning, edge.from, edge.to()));
  }

  /// Pieces come in order, so that equal neighbours grow together.
  void add_piece(const Edge& piece, std::uint32_t value) {
    const std::uint32_t color = look_.colors.color(value);
    if (lines_.size() > first_ && lines_.back().color == color) {
      lines_.back().to = piece.to();
    } else {
      lines_.push_back({piece.from, piece.to(), color, look_.width});
    }
  }

  LineList& lines_;
  const EdgeLook& look_;
  std::size_t first_;  // index into lines_ of the edge's first piece
};

}  // namespace

void add_edge(LineList& lines, const EdgeLook& look, const Edge& edge, EdgeNodes nodes) {
  EdgeWalk(lines, look).walk(edge, nodes);
}

}  // namespace bspview
