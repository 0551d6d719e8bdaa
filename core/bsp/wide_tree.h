#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/bsp/tree.h"

namespace bspview {

/// Up to eight cells of a BSP tree side by side, each shrunk to the boxes of what it holds. Empty
/// cells are left out. A slot without a cell has an empty box (lo = inf, hi = -inf).
struct alignas(32) WideNode {
  static constexpr int width = 8;
  static constexpr std::uint32_t leaf_bit = 0x80000000u;

  float bounds[6][width];      ///< rows: lo and hi of x, of y, of z
  std::uint32_t child[width];  ///< index of a node, or leaf_bit and the name of a leaf
};

/// A BSP tree in nodes of eight cells, for rays that test them all at once: what a ray does in
/// three or more steps of the binary tree, most of them mispredicted, is one step here. Its cells
/// are disjoint as those of the binary tree: whatever a ray hits in the nearest is the nearest hit.
struct WideTree {
  std::vector<WideNode> nodes;  ///< nodes[0] is the root; a lone leaf is its only child

  std::size_t bytes() const { return nodes.size() * sizeof(WideNode); }
};

/// What the leaves of a wide tree are.
struct WideLeaves {
  /// Stores the objects of a leaf (ascending ids, at least one) and answers its name, < leaf_bit.
  std::function<std::uint32_t(std::span<const std::uint32_t> objects)> make;
  /// Whether leaves that hold this object may be joined with their neighbours: where
  /// most_joined_objects at once cost no more than one.
  std::function<bool(std::uint32_t object)> joins;
};
inline constexpr int most_joined_objects = 8;

/// `boxes`: one an object, as the tree was built with or larger. Null soon after a stop is
/// requested.
std::optional<WideTree> make_wide_tree(const Tree& tree, std::span<const Aabb> boxes,
                                       const WideLeaves& leaves, std::stop_token stop = {});

}  // namespace bspview
