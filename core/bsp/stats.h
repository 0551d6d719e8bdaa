#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/bsp/tree.h"

namespace bspview {

/// What can be said of a tree without a ray.
struct TreeStats {
  std::uint64_t nodes = 0, inner = 0, leaves = 0, empty_leaves = 0, references = 0;
  int deepest_leaf = 0;                          ///< the root has depth 0
  double full_volume = 0.0;                      ///< of the non-empty leaves
  double volume = 0.0;                           ///< of the root
  double expected_cost = 0.0;                    ///< SAH, in the units of the params' costs
  std::vector<std::uint64_t> leaves_at_depth;    ///< index: depth
  std::vector<std::uint64_t> leaves_with_count;  ///< index: objects in the leaf
  bool operator==(const TreeStats&) const = default;
};
/// Soon after a stop is requested: of some of the nodes.
TreeStats tree_stats(const Tree& tree, const std::stop_token& stop = {});

/// Calls visit(node index, cell, depth) for every node, parents first; a node whose visit returns
/// false is not descended into.
using NodeVisitor = std::function<bool(std::uint32_t node, const Aabb& cell, int depth)>;
void visit_nodes(const Tree& tree, const NodeVisitor& visit);

/// The leaf whose cell holds `point`; a point on a plane belongs to the left cell.
/// no_leaf when the point is outside the tree's box.
std::uint32_t find_leaf(const Tree& tree, Vec3 point);

}  // namespace bspview
