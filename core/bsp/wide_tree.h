#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>

#include "core/base/raw_vector.h"
#include "core/bsp/object_groups.h"
#include "core/bsp/tree.h"

namespace bspview {

/// Up to sixteen cells of a BSP tree side by side, each shrunk to the boxes of what it holds. Empty
/// cells are left out. A slot without a cell has an empty box (lo = inf, hi = -inf). Cells below
/// which the fewest steps are expected come last.
struct alignas(64) WideNode {
  static constexpr int width = 16;
  static constexpr std::uint32_t leaf_bit = 0x80000000u;

  float bounds[6][width];      ///< rows: lo and hi of x, of y, of z
  std::uint32_t child[width];  ///< index of a node, or leaf_bit and the name of a leaf

  void set_bounds(int slot, const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      bounds[2 * axis][slot] = box.lo[axis];
      bounds[2 * axis + 1][slot] = box.hi[axis];
    }
  }
  Aabb box(int slot) const {
    return {{bounds[0][slot], bounds[2][slot], bounds[4][slot]},
            {bounds[1][slot], bounds[3][slot], bounds[5][slot]}};
  }
  static WideNode without_cells() {
    WideNode node{};
    for (int slot = 0; slot < width; ++slot) node.set_bounds(slot, {});
    return node;
  }
};

/// A BSP tree in nodes of sixteen cells, for rays that test them all at once: what a ray does in
/// four or more steps of the binary tree, most of them mispredicted, is one step here. Its cells
/// are disjoint as those of the binary tree, but for the groups that the objects of small branches
/// are dealt out to: what a ray hits in one of these may be behind what it hits in the next.
struct WideTree {
  /// Nodes of the binary tree and of groups one below the other, at most.
  static constexpr int most_levels = depth_cap + ObjectGroups::most_levels;

  /// Depth first, so that a branch lies together. nodes[0] is the root; a lone leaf is its only
  /// child.
  RawVector<WideNode> nodes;

  std::size_t bytes() const { return nodes.size() * sizeof(WideNode); }
};

/// The objects of the leaves of a wide tree, the leaves in the order of the nodes. Each leaf is a
/// large one of the binary tree, or a group of the objects of a small branch.
struct WideLeaves {
  struct Range {
    std::uint32_t first, count;  ///< of `objects`
  };

  std::size_t size() const { return ranges.size(); }
  /// Ascending ids, at least one.
  std::span<const std::uint32_t> operator[](std::size_t leaf) const {
    return std::span(objects).subspan(ranges[leaf].first, ranges[leaf].count);
  }

  RawVector<Range> ranges;  ///< by leaf
  RawVector<std::uint32_t> objects;
};

/// What a wide tree has to know of an object.
struct WideObject {
  Aabb box;                ///< as the tree was built with, or larger
  bool is_eighth = false;  ///< eight like it are tested at once, see ObjectTests
  bool is_alone = false;   ///< is no object but a tree of its own, the only one in its leaf
};

/// The objects of a tree.
struct WideObjects {
  /// A box around the part of an object in a cell, or a little larger; empty only where there is
  /// none. Called from several threads.
  using PartFunction = std::function<Aabb(std::uint32_t object, const Aabb& cell)>;

  std::span<const WideObject> list;
  PartFunction part;
};

struct Widened {
  WideTree tree;  ///< its leaves are named by their number
  WideLeaves leaves;
};

/// The same for any number of threads (of the enclosing with_threads). Nothing soon after a stop is
/// requested.
std::optional<Widened> widen(const Tree& tree, const WideObjects& objects,
                             std::stop_token stop = {});

}  // namespace bspview
