#pragma once

#include <optional>
#include <stop_token>

#include "app/viewer/overlays/box_pruning.h"
#include "app/viewer/overlays/color_scale.h"
#include "app/viewer/overlays/leaf_mask.h"
#include "app/viewer/overlays/line_list.h"
#include "core/bsp/stats.h"

namespace bspview {

/// What the colour of a leaf's box says.
enum class LeafColor { plain, objects, depth };

/// Looks of the boxes; compares by value.
struct NodeBoxStyle {
  LeafColor color_by = LeafColor::objects;
  ColorScale scale;                   ///< not for plain; see leaf_color_scale
  std::uint32_t plain = 0xffffffffu;  ///< RGBA as in Line
  float alpha = 1.0f;
  float width = 1.0f;  ///< pixels
  bool operator==(const NodeBoxStyle&) const = default;
};

/// Scale from 0 to the fullest leaf (logarithmic) or from 0 to the deepest leaf (linear).
[[nodiscard]] ColorScale leaf_color_scale(const TreeStats& stats, LeafColor color_by, ColorMap map);

/// The edges of the boxes of the shown leaves.
///
/// A subtree that is shown as a whole is drawn by its own box and its split rectangles, the 4 edges
/// that each inner node's plane adds: the same edges with a third of the lines. When coloured, an
/// edge of a split rectangle changes its colour along its length: everywhere it has the greatest
/// value of the leaves of its node that touch it there.
/// O(visited nodes) when plain; coloured edges add their walks down the tree. Returns what there is
/// so far when `stop` is requested.
[[nodiscard]] LineList node_box_lines(const Tree& tree, const LeafMask& shown,
                                      const NodeBoxStyle& style,
                                      const std::optional<BoxPruning>& pruning = {},
                                      std::stop_token stop = {});

}  // namespace bspview
