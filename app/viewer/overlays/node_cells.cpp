#include "app/viewer/overlays/node_cells.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/parallel.h"

namespace bspview {

NodeCells::NodeCells(const Tree& tree, const std::stop_token& stop) : tree_(tree) {
  constexpr std::size_t nodes_between_looks = std::size_t{1} << 15;
  parents_.resize(tree.nodes.size());
  if (!parents_.empty()) parents_[0] = 0;
  parallel_ranges(tree.nodes.size(), nodes_between_looks, [&](std::size_t first, std::size_t last) {
    if (stop.stop_requested()) return;
    for (std::size_t i = first; i < last; ++i) {
      const Node& node = tree.nodes[i];
      if (node.is_leaf()) continue;
      parents_[node.left()] = parents_[node.right()] = static_cast<std::uint32_t>(i);
    }
  });
}

std::vector<std::uint32_t> NodeCells::path(std::uint32_t node) const {
  BSPVIEW_CHECK(node < parents_.size());
  std::vector<std::uint32_t> nodes{node};
  while (nodes.back() != 0) nodes.push_back(parents_[nodes.back()]);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

int NodeCells::depth(std::uint32_t node) const {
  BSPVIEW_CHECK(node < parents_.size());
  int depth = 0;
  for (; node != 0; node = parents_[node]) ++depth;
  return depth;
}

Aabb NodeCells::cell(std::uint32_t node) const {
  Aabb box = tree_.box;
  const std::vector<std::uint32_t> nodes = path(node);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Node& parent = tree_.nodes[nodes[i]];
    const Cells cells = split_cell(box, parent.axis(), parent.split());
    box = nodes[i + 1] == parent.left() ? cells.left : cells.right;
  }
  return box;
}

}  // namespace bspview
