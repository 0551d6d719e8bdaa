#include "core/eval/delta.h"

#include <algorithm>

namespace bspview {
namespace {

/// nullopt where there is nothing to divide by.
std::optional<double> ratio(double part, double whole) {
  if (!(whole > 0.0)) return std::nullopt;
  return part / whole;
}

std::optional<double> ratio(std::uint64_t part, std::uint64_t whole) {
  return ratio(static_cast<double>(part), static_cast<double>(whole));
}

}  // namespace

Delta compute_delta(const TreeStats& tree, std::size_t objects) {
  Delta delta;
  delta.n_ls = tree.leaves;
  delta.r_etnls = ratio(tree.empty_leaves, tree.leaves);
  delta.n_adl = ratio(tree.references, objects);
  delta.n_aoial = ratio(tree.references, tree.leaves);
  delta.n_aoifl = ratio(tree.references, tree.leaves - tree.empty_leaves);
  // A sum of rounded parts may pass the whole.
  delta.r_fvwv = ratio(std::min(tree.full_volume, tree.volume), tree.volume);
  return delta;
}

Delta compute_delta(const TreeStats& tree, std::size_t objects, const RayCounts& rays) {
  Delta delta = compute_delta(tree, objects);
  delta.n_rprt = ratio(rays.tests, rays.minimal_tests());
  delta.n_at = ratio(rays.nodes_inner + rays.nodes_leaf, rays.all());
  return delta;
}

}  // namespace bspview
