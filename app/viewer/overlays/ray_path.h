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

/// Lines of the selected ray: the leaf cells it visits in order (colour from first to last), a mark
/// at the entry and exit of each, outlines of the objects tested in them, the ray itself and its
/// hit; the highlighted step's cell and objects stand out. The pixel's other rays are thin.
/// Later lines are more important ones. O(rays + steps x depth + vertices of tested objects).
[[nodiscard]] LineList ray_path_lines(const RayPathScene& world, std::span<const PathRay> rays,
                                      const RaySelection& selection);

}  // namespace bspview
