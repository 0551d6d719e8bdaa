#include "app/viewer/overlays/leaf_colors.h"

#include <algorithm>

#include "app/viewer/overlays/rgba.h"

namespace bspview {
namespace {

/// Parents come before their children.
std::vector<std::uint32_t> greatest_values(const Tree& tree, LeafColor color_by) {
  std::vector<std::uint32_t> values(tree.nodes.size(), 0);
  const bool by_depth = color_by == LeafColor::depth;
  for (std::size_t i = 0; by_depth && i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (!node.is_leaf()) values[node.left()] = values[node.right()] = values[i] + 1;
  }
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    if (!node.is_leaf()) {
      values[i] = std::max(values[node.left()], values[node.right()]);
    } else if (!by_depth) {
      values[i] = node.count();
    }
  }
  return values;
}

}  // namespace

ColorScale leaf_color_scale(const TreeStats& stats, LeafColor color_by, ColorMap map) {
  if (color_by == LeafColor::depth) {
    return {map, 0.0f, static_cast<float>(stats.deepest_leaf), ColorScale::Spacing::linear};
  }
  const std::size_t counts = std::max<std::size_t>(stats.leaves_with_count.size(), 1);
  return {map, 0.0f, static_cast<float>(counts - 1), ColorScale::Spacing::logarithmic};
}

LeafColors::LeafColors(const Tree& tree, const NodeBoxStyle& style) : style_(style) {
  if (style.color_by == LeafColor::plain) {
    table_ = {style.plain};
    return;
  }
  constexpr std::uint32_t table_size = 1024;
  values_ = greatest_values(tree, style.color_by);
  for (std::uint32_t value = 0; value < table_size; ++value) {
    table_.push_back(find_color(value));
  }
}

std::uint32_t LeafColors::find_color(std::uint32_t value) const {
  const float position = position_on(style_.scale, static_cast<float>(value));
  return pack_color(color_at(style_.scale, position), style_.alpha);
}

}  // namespace bspview
