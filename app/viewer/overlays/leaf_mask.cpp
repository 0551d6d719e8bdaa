#include "app/viewer/overlays/leaf_mask.h"

namespace bspview {
namespace {

/// Of all nodes; zeros where the filter takes leaves of every depth.
std::vector<std::uint8_t> depths_for(const LeafFilter& filter, const Tree& tree) {
  std::vector<std::uint8_t> depths(tree.nodes.size(), 0);
  if (filter.min_depth <= 0 && filter.max_depth >= tree.max_depth) return depths;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf()) continue;
    depths[node.left()] = depths[node.right()] = static_cast<std::uint8_t>(depths[i] + 1);
  }
  return depths;
}

bool passes(const LeafFilter& filter, const Node& leaf, int depth) {
  const bool full = leaf.count() > 0;
  if (filter.contents == LeafFilter::Contents::full && !full) return false;
  if (filter.contents == LeafFilter::Contents::empty && full) return false;
  return filter.min_depth <= depth && depth <= filter.max_depth;
}

/// Sets the entries of inner nodes from those of the leaves; parents come before their children.
void fill_inner(const Tree& tree, LeafMask& mask) {
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf()) continue;
    const Shown left = mask[node.left()], right = mask[node.right()];
    mask[i] = left == right ? left : Shown::some;
  }
}

}  // namespace

LeafMask filter_leaves(const Tree& tree, const LeafFilter& filter) {
  const std::vector<std::uint8_t> depths = depths_for(filter, tree);
  LeafMask mask(tree.nodes.size(), Shown::none);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf() && passes(filter, node, depths[i])) mask[i] = Shown::all;
  }
  fill_inner(tree, mask);
  return mask;
}

LeafMask choose_leaves(const Tree& tree, const LeafFilter& filter,
                       std::span<const std::uint32_t> nodes) {
  const std::vector<std::uint8_t> depths = depths_for(filter, tree);
  LeafMask mask(tree.nodes.size(), Shown::none);
  for (const std::uint32_t i : nodes) {
    if (i >= tree.nodes.size() || !tree.nodes[i].is_leaf()) continue;
    if (passes(filter, tree.nodes[i], depths[i])) mask[i] = Shown::all;
  }
  fill_inner(tree, mask);
  return mask;
}

std::vector<std::uint32_t> touched_leaves(const Tree& tree, std::span<const std::uint32_t> surface,
                                          std::span<const PathRay> rays) {
  std::vector<bool> touched(tree.nodes.size(), false);
  const auto touch = [&](std::uint32_t node) {
    if (node < touched.size() && tree.nodes[node].is_leaf()) touched[node] = true;
  };
  for (const std::uint32_t node : surface) touch(node);
  for (const PathRay& ray : rays) {
    for (const RayStep& step : ray.log.steps) touch(step.node);
  }
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t i = 0; i < touched.size(); ++i) {
    if (touched[i]) leaves.push_back(i);
  }
  return leaves;
}

}  // namespace bspview
