#pragma once

#include <string>
#include <vector>

#include "core/render/render.h"

namespace bspview {

/// One step of a ray through the tree, as text.
struct RayTableRow {
  std::string step;      ///< "3", from 1
  std::string node;      ///< "17"
  std::string visits;    ///< inner nodes: the children, "near, far", "near", "far"; leaves: "leaf"
  std::string split;     ///< "x = 1.25"; "" for leaves
  std::string t_split;   ///< where the ray meets the plane: "1.31", "never"; "" for leaves
  std::string interval;  ///< of the ray in the cell: "0.5 to 1.75"
  std::string tests;     ///< "2, hits object 7 at 1.31"; "" for inner nodes
  bool operator==(const RayTableRow&) const = default;
};

/// One row a step, in the order of the walk.
[[nodiscard]] std::vector<RayTableRow> ray_table(const PathRay& ray);

/// "1 eye ray: hits object 7 at t = 1.31", for the list that a ray is selected from; `index`
/// counts from 0.
[[nodiscard]] std::string ray_title(const PathRay& ray, int index);

/// "23 steps, 9 leaves, 14 tests".
[[nodiscard]] std::string ray_summary(const PathRay& ray);

}  // namespace bspview
