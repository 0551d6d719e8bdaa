#pragma once

#include <optional>
#include <stop_token>

#include "app/viewer/overlays/box_pruning.h"
#include "app/viewer/overlays/leaf_colors.h"
#include "app/viewer/overlays/leaf_mask.h"
#include "app/viewer/overlays/line_list.h"

namespace bspview {

/// The edges of the boxes of the shown leaves.
///
/// A subtree that is shown as a whole is drawn by its own box and its split rectangles, the 4 edges
/// that each inner node's plane adds: the same edges with a third of the lines. When coloured, an
/// edge of a split rectangle changes its colour along its length: everywhere it has the greatest
/// value of the leaves of its node that touch it there.
///
/// O(visited nodes) when plain; coloured edges add their walks down the tree. Runs on the threads
/// of the enclosing with_threads, which change nothing. What there is so far when `stop` was
/// requested.
[[nodiscard]] LineList node_box_lines(const Tree& tree, const LeafMask& shown,
                                      const NodeBoxStyle& style,
                                      const std::optional<BoxPruning>& pruning = {},
                                      const std::stop_token& stop = {});

}  // namespace bspview
