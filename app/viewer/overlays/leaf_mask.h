#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/bsp/tree.h"
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

/// The leaves among `nodes` (indices; other entries are ignored) that pass `filter`.
/// O(nodes of the tree + nodes).
[[nodiscard]] LeafMask choose_leaves(const Tree& tree, const LeafFilter& filter,
                                     std::span<const std::uint32_t> nodes);

/// Node indices, each once, ascending: of the leaves on the visible surface (`surface` is
/// Frame::leaf) and of those that `rays` visited. O(nodes + pixels + steps).
[[nodiscard]] std::vector<std::uint32_t> touched_leaves(const Tree& tree,
                                                        std::span<const std::uint32_t> surface,
                                                        std::span<const PathRay> rays);

}  // namespace bspview
