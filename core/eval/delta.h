#pragma once

#include <optional>

#include "core/bsp/stats.h"
#include "core/render/ray_counts.h"

namespace bspview {

/// The septet of Havran's "Evaluation of BSP trees for ray-tracing", and the derived eighth.
/// nullopt: not defined (nothing to divide by).
struct Delta {
  std::uint64_t n_ls = 0;         ///< N_LS: leaves
  std::optional<double> r_etnls;  ///< empty leaves / leaves
  std::optional<double> n_adl;    ///< references / objects
  std::optional<double> n_aoial;  ///< references / leaves (derived)
  std::optional<double> n_aoifl;  ///< references / full leaves
  std::optional<double> r_fvwv;   ///< volume of the full leaves / volume of the root
  std::optional<double> n_rprt;   ///< tests / rays that hit something
  std::optional<double> n_at;     ///< visited nodes, leaves included / rays
  bool operator==(const Delta&) const = default;
};

/// The six that need the tree alone; then all eight.
Delta compute_delta(const TreeStats& tree, std::size_t objects);
Delta compute_delta(const TreeStats& tree, std::size_t objects, const RayCounts& rays);

}  // namespace bspview
