#include "app/viewer/overlays/leaf_mask.h"

#include <utility>

namespace bspview {
namespace {

bool takes_every_depth(const LeafFilter& filter, const Tree& tree) {
  return filter.min_depth <= 0 && filter.max_depth >= tree.max_depth;
}

/// Of all nodes; zeros where the filter takes leaves of every depth.
std::vector<std::uint8_t> depths_for(const LeafFilter& filter, const Tree& tree) {
  std::vector<std::uint8_t> depths(tree.nodes.size(), 0);
  if (takes_every_depth(filter, tree)) return depths;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf()) continue;
    depths[node.left()] = depths[node.right()] = static_cast<std::uint8_t>(depths[i] + 1);
  }
  return depths;
}

bool passes(const LeafFilter& filter, const Node& leaf, int depth) {
  const bool full = leaf.count() > 0;
  if (filter.contents == LeafFilter::Contents::full && !full) return false;
  if (filter.contents == LeafFilter::Contents::empty && full) return false;
  return filter.min_depth <= depth && depth <= filter.max_depth;
}

/// A node is shown as a whole where both children are, and in part where one is in part.
Shown shown_of(const Node& parent, const LeafMask& mask) {
  const Shown left = mask[parent.left()], right = mask[parent.right()];
  return left == right ? left : Shown::some;
}

/// Sets the entries of inner nodes from those of the leaves; parents come before their children.
void fill_inner(const Tree& tree, LeafMask& mask) {
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    if (!node.is_leaf()) mask[i] = shown_of(node, mask);
  }
}

/// Leaves that are shown one by one.
class Touched {
 public:
  Touched(const NodeCells& cells, const LeafFilter& filter)
      : cells_(cells),
        tree_(cells.tree()),
        filter_(filter),
        needs_depth_(!takes_every_depth(filter, tree_)),
        seen_(tree_.nodes.size(), false),
        mask_(tree_.nodes.size(), Shown::none) {}

  /// Whatever is no leaf is ignored.
  void touch(std::uint32_t node) {
    if (node >= seen_.size() || seen_[node] || !tree_.nodes[node].is_leaf()) return;
    seen_[node] = true;
    const int depth = needs_depth_ ? cells_.depth(node) : 0;
    if (passes(filter_, tree_.nodes[node], depth)) show(node);
  }

  LeafMask take_mask() { return std::move(mask_); }

 private:
  /// And in the nodes above, as far as they change.
  void show(std::uint32_t node) {
    mask_[node] = Shown::all;
    while (node != 0) {
      node = cells_.parent(node);
      const Shown shown = shown_of(tree_.nodes[node], mask_);
      if (mask_[node] == shown) return;
      mask_[node] = shown;
    }
  }

  const NodeCells& cells_;
  const Tree& tree_;
  const LeafFilter& filter_;
  const bool needs_depth_;
  std::vector<bool> seen_;  // by node: leaves that do not pass, too
  LeafMask mask_;
};

}  // namespace

LeafMask filter_leaves(const Tree& tree, const LeafFilter& filter) {
  const std::vector<std::uint8_t> depths = depths_for(filter, tree);
  LeafMask mask(tree.nodes.size(), Shown::none);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf() && passes(filter, node, depths[i])) mask[i] = Shown::all;
  }
  fill_inner(tree, mask);
  return mask;
}

LeafMask touched_leaves(const NodeCells& cells, const LeafFilter& filter,
                        std::span<const std::uint32_t> surface, std::span<const PathRay> rays) {
  Touched touched(cells, filter);
  for (const std::uint32_t node : surface) touched.touch(node);
  for (const PathRay& ray : rays) {
    for (const RayStep& step : ray.log.steps) touched.touch(step.node);
  }
  return touched.take_mask();
}

}  // namespace bspview
