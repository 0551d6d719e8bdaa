#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include "core/base/raw_vector.h"
#include "core/bsp/tree.h"
#include "core/bsp/wide_tree.h"

namespace bspview {

struct GroupedNode {
  Aabb box;             ///< of the parts of objects in its cell, or in its group
  std::uint32_t inner;  ///< inner nodes from here down; 0: it is a leaf
  std::uint32_t first;  ///< left child; of a leaf: index of its first object
  std::uint32_t other;  ///< right child; of a leaf: number of its objects
  /// What a ray is expected to cost from here down, in steps through wide nodes and times
  /// GroupedTree::area: with at most 1, 2 ... cells of a wide node above.
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
CellShares share_cells(const GroupedNode& left, const GroupedNode& right, int cells);

/// The upper part of a BSP tree without its empty leaves. The objects of each of its branches that
/// holds few are dealt out to groups (ObjectGroups), unless planes are cheaper.
struct GroupedTree {
  /// Half of the surface of a box, in a unit of its own (area_unit).
  float area(const Aabb& box) const { return half_area({unit * box.lo, unit * box.hi}); }

  float unit = 1.0f;
  RawVector<GroupedNode> nodes;      ///< children come before their parents; the last is the root
  RawVector<std::uint32_t> objects;  ///< ascending ids in every leaf
};

/// The same for any number of threads. Without use once a stop is requested.
GroupedTree group_objects(const Tree& tree, const WideObjects& objects,
                          const std::stop_token& stop);

}  // namespace bspview
