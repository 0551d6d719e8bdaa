#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include "core/base/raw_vector.h"
#include "core/bsp/tree.h"
#include "core/bsp/wide_tree.h"

namespace bspview {

struct JoinedNode {
  Aabb box;             ///< of the parts of objects in its cell, or in its group
  std::uint32_t inner;  ///< inner nodes from here down; 0: it is a leaf
  std::uint32_t first;  ///< left child; of a leaf: index of its first object
  std::uint32_t other;  ///< right child; of a leaf: number of its objects
  /// What a ray is expected to cost from here down, in steps through wide nodes and times
  /// half_area: with at most 1, 2 ... cells of a wide node above.
  float cost[WideNode::width - 1];

  bool is_leaf() const { return inner == 0; }
};

/// Cells of a wide node dealt out between two nodes: the least that they cost, and how many the
/// left one has.
struct CellShares {
  float cost;
  int left;
};
/// `cells`: 2 to WideNode::width.
CellShares share_cells(const JoinedNode& left, const JoinedNode& right, int cells);

/// A binary tree without empty leaves. Leaves of few objects are joined with their neighbours where
/// they may be, the objects of larger ones are dealt out to groups (ObjectGroups).
struct JoinedTree {
  RawVector<JoinedNode> nodes;       ///< children come before their parents; the last is the root
  RawVector<std::uint32_t> objects;  ///< ascending ids in every leaf
};

/// The same for any number of threads. Without use once a stop is requested.
JoinedTree join_leaves(const Tree& tree, std::span<const WideObject> objects,
                       const std::stop_token& stop);

}  // namespace bspview
