#pragma once

#include <cstdint>
#include <vector>

#include "app/viewer/overlays/color_scale.h"
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

/// Value and colour of every node: a leaf's own, an inner node's greatest of the leaves below.
class LeafColors {
 public:
  /// O(nodes), O(1) when plain. The style must outlive it.
  LeafColors(const Tree& tree, const NodeBoxStyle& style);

  bool plain() const { return values_.empty(); }
  std::uint32_t value(std::uint32_t node) const { return plain() ? 0 : values_[node]; }
  /// RGBA as in Line.
  std::uint32_t color(std::uint32_t value) const {
    return value < table_.size() ? table_[value] : find_color(value);
  }

 private:
  std::uint32_t find_color(std::uint32_t value) const;

  const NodeBoxStyle& style_;
  std::vector<std::uint32_t> values_;  // index: node; empty when plain
  std::vector<std::uint32_t> table_;   // index: value; greater ones are rare
};

}  // namespace bspview
