#pragma once

#include "app/viewer/overlays/box_pruning.h"
#include "app/viewer/overlays/leaf_colors.h"
#include "app/viewer/overlays/line_list.h"

namespace bspview {

/// An edge parallel to `axis`.
struct Edge {
  int axis = 0;
  Vec3 from{0.0f};
  float end = 0.0f;  ///< coordinate on the axis

  Vec3 to() const {
    Vec3 point = from;
    point[axis] = end;
    return point;
  }
};

/// What edges of cells look like. All but `pruning`, which may be null, outlive every call.
struct EdgeLook {
  const Tree& tree;
  const LeafColors& colors;
  float width;                ///< pixels
  const BoxPruning* pruning;  ///< pieces that look shorter than its min_pixels are one
};

/// The two nodes beside an edge; both have it as an edge of their cell. The same one twice for the
/// edge of a box.
struct EdgeNodes {
  std::uint32_t a, b;
};

/// Adds the edge, piece by piece: each has the greatest value of the leaves that touch it, below
/// either node. O(1) when plain, else O(leaves along the edge x depth).
void add_edge(LineList& lines, const EdgeLook& look, const Edge& edge, EdgeNodes nodes);

}  // namespace bspview
