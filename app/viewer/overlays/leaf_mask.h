#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/viewer/overlays/node_cells.h"
#include "core/render/render.h"

namespace bspview {

/// Which leaves of a tree an overlay shows; compares by value.
struct LeafFilter {
  enum class Contents { all, full, empty };

  Contents contents = Contents::all;
  int min_depth = 0, max_depth = depth_cap;  ///< of the leaf; the root has depth 0
  bool operator==(const LeafFilter&) const = default;
};

/// How much of a subtree is shown.
enum class Shown : std::uint8_t { none, some, all };

/// One entry a node of the tree.
using LeafMask = std::vector<Shown>;

/// The leaves that pass `filter`. O(nodes).
[[nodiscard]] LeafMask filter_leaves(const Tree& tree, const LeafFilter& filter);

/// The leaves that pass `filter` and are on the visible surface (`surface` is Frame::leaf) or on
/// the way of `rays`. O(pixels + steps + leaves x depth), apart from room for the nodes.
[[nodiscard]] LeafMask touched_leaves(const NodeCells& cells, const LeafFilter& filter,
                                      std::span<const std::uint32_t> surface,
                                      std::span<const PathRay> rays);

}  // namespace bspview
