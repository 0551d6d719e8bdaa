#pragma once

namespace bspview {

/// Extent of what is drawn on.
struct WindowSize {
  int width = 1280, height = 800;  ///< in the units of the cursor
  int pixel_width = 1280, pixel_height = 800;
  float content_scale = 1.0f;  ///< of text and widgets, as the display asks for

  bool operator==(const WindowSize&) const = default;
  bool empty() const { return width <= 0 || height <= 0 || pixel_width <= 0 || pixel_height <= 0; }
};

}  // namespace bspview
