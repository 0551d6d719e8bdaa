#include "app/viewer/overlays/node_boxes.h"

#include <utility>

#include "app/viewer/overlays/edge_lines.h"
#include "core/base/parallel.h"

namespace bspview {
namespace {

constexpr int task_depth = 7;  // subtrees at this depth are collected as one task each

/// A node with its cell.
struct Subtree {
  std::uint32_t node;
  Aabb cell;
  int depth;
};

/// A subtree left to be drawn.
struct Task {
  Subtree subtree;
  bool box_drawn;  // only the split rectangles are missing
};

struct BoxScene {
  const Tree& tree;
  const LeafMask& shown;
  const EdgeLook& look;
  const std::stop_token& stop;
};

/// Collects the lines of a subtree, in part or as a whole.
class BoxLines {
 public:
  /// Subtrees at depth `last` become tasks.
  BoxLines(const BoxScene& scene, int last) : scene_(scene), last_(last) {}

  void draw(const Task& task) {
    if (task.box_drawn) {
      draw_splits(task.subtree);
    } else {
      draw_shown(task.subtree);
    }
  }

  LineList lines;
  std::vector<Task> tasks;

 private:
  void draw_shown(const Subtree& subtree) {
    const Shown shown = scene_.shown[subtree.node];
    if (shown == Shown::none || scene_.stop.stop_requested()) return;
    const OnScreen on_screen = place(subtree.cell);
    if (on_screen == OnScreen::outside) return;
    if (shown == Shown::all || on_screen == OnScreen::small) {
      draw_box(subtree);
      draw_splits(subtree);
      return;
    }
    if (subtree.depth == last_) {
      tasks.push_back({subtree, false});
      return;
    }
    const auto [left, right] = children(subtree);
    draw_shown(left);
    draw_shown(right);
  }

  /// The split rectangles of the subtree.
  void draw_splits(const Subtree& subtree) {
    const Node& node = scene_.tree.nodes[subtree.node];
    if (node.is_leaf() || scene_.stop.stop_requested()) return;
    if (subtree.depth == last_) {
      tasks.push_back({subtree, true});
      return;
    }
    if (place(subtree.cell) != OnScreen::large) return;
    const auto [left, right] = children(subtree);
    draw_rectangle(left.cell, node);
    draw_splits(left);
    draw_splits(right);
  }

  OnScreen place(const Aabb& cell) const {
    return scene_.look.pruning ? find_on_screen(*scene_.look.pruning, cell) : OnScreen::large;
  }

  std::pair<Subtree, Subtree> children(const Subtree& parent) const {
    const Node& node = scene_.tree.nodes[parent.node];
    const Cells cells = split_cell(parent.cell, node.axis(), node.split());
    const int depth = parent.depth + 1;
    return {{node.left(), cells.left, depth}, {node.right(), cells.right, depth}};
  }

  void draw_box(const Subtree& subtree) {
    for_box_edges(subtree.cell, [&](int axis, Vec3 from) {
      const Edge edge{axis, from, subtree.cell.hi[axis]};
      add_edge(lines, scene_.look, edge, {subtree.node, subtree.node});
    });
  }

  /// The edges of the face that the children of `node` share.
  void draw_rectangle(const Aabb& left_cell, const Node& node) {
    const auto& [lo, hi] = left_cell;
    for (int i = 1; i <= 2; ++i) {
      const int along = (node.axis() + i) % 3, across = (node.axis() + 3 - i) % 3;
      Vec3 from = lo;
      from[node.axis()] = node.split();
      add_edge(lines, scene_.look, {along, from, hi[along]}, {node.left(), node.right()});
      from[across] = hi[across];
      add_edge(lines, scene_.look, {along, from, hi[along]}, {node.left(), node.right()});
    }
  }

  const BoxScene& scene_;
  int last_;
};

}  // namespace

LineList node_box_lines(const Tree& tree, const LeafMask& shown, const NodeBoxStyle& style,
                        const std::optional<BoxPruning>& pruning, const std::stop_token& stop) {
  if (tree.nodes.empty() || tree.box.empty()) return {};
  const LeafColors colors(tree, style);
  const EdgeLook look{tree, colors, style.width, pruning ? &*pruning : nullptr};
  const BoxScene scene{tree, shown, look, stop};
  BoxLines top(scene, task_depth);
  top.draw({{0, tree.box, 0}, false});
  std::vector<LineList> parts(top.tasks.size());
  parallel_for(static_cast<int>(parts.size()), [&](int i) {
    BoxLines part(scene, depth_cap + 1);
    part.draw(top.tasks[i]);
    parts[i] = std::move(part.lines);
  });
  for (const LineList& part : parts) {
    top.lines.insert(top.lines.end(), part.begin(), part.end());
  }
  return std::move(top.lines);
}

}  // namespace bspview
