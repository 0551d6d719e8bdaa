#pragma once

#include <span>

#include "app/viewer/overlays/line_list.h"
#include "app/viewer/overlays/node_cells.h"
#include "app/viewer/overlays/screen_transform.h"
#include "core/render/render.h"

namespace bspview {

/// What of a pixel's rays is looked at; compares by value.
struct RaySelection {
  int ray = 0;    ///< index into the rays of the pixel
  int step = -1;  ///< index into its steps, highlighted; -1: none
  bool operator==(const RaySelection&) const = default;
};

/// What the rays went through. All outlive the call.
struct RayPathScene {
  const Scene& scene;
  const NodeCells& cells;
  const ScreenTransform& transform;  ///< gives the marks their size in pixels
};

/// RGBA, as in Line, of a kind of ray in the scene, in the table and in lists.
[[nodiscard]] std::uint32_t ray_color(RayKind kind);

/// RGBA of the leaf cells along the selected ray; `order` is 0 for the first and 1 for the last.
[[nodiscard]] std::uint32_t cell_color(float order);

/// RGBA of the mark at a hit.
[[nodiscard]] std::uint32_t hit_color();

/// Lines of the selected ray: the leaf cells that it visits (cell_color),
/// outlines of the objects tested there (each once; at most 1000), a mark where it enters and
/// leaves each cell, the ray and a diamond at its hit. The cell of the highlighted step is white
/// and thick, and so are the objects tested in it. The pixel's other rays are thin. Later lines
/// matter more.
[[nodiscard]] LineList ray_path_lines(const RayPathScene& world, std::span<const PathRay> rays,
                                      const RaySelection& selection);

}  // namespace bspview
