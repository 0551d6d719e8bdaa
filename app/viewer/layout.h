#pragma once

#include "core/math/vec.h"

namespace bspview {

/// Axis-aligned rectangle on the screen, in window coordinates.
struct Rect {
  float x = 0.0f, y = 0.0f, width = 0.0f, height = 0.0f;

  bool operator==(const Rect&) const = default;
  float right() const { return x + width; }
  float bottom() const { return y + height; }
  bool contains(Vec2 p) const { return x <= p.x && p.x < right() && y <= p.y && p.y < bottom(); }
};

/// Where the user has dragged the splitters.
struct Splits {
  float left = 262.0f;   ///< width of the left column, in pixels at scale 1
  float right = 356.0f;  ///< width of the right column, in pixels at scale 1
  float ray = 0.40f;     ///< share of the right column that the ray panel takes

  bool operator==(const Splits&) const = default;
};

/// What a layout is made for.
struct LayoutInput {
  Vec2 window{0.0f};
  float scale = 1.0f;
  float bar_height = 22.0f;  ///< of menu and status bar, in pixels of the window
  Splits splits;
  bool panels = true;  ///< false: the picture fills the window
};

/// The fixed regions of the window; they tile it. A hidden region has no extent.
struct Layout {
  Rect menu, left, view, measures, ray, status;
};
Layout make_layout(const LayoutInput& input);

/// `splits` with every region left large enough to be used.
Splits clamp_splits(const LayoutInput& input);

}  // namespace bspview
