#pragma once

#include <imgui.h>

namespace bspview {

/// The fonts of the interface. Where DejaVu Sans is not installed they are Dear ImGui's own, which
/// has no Greek letters.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* bold = nullptr;
  bool greek = false;  ///< Δ and Λ can be drawn
  float size = 13.0f;  ///< of `text`, pixels
};

/// Replaces the fonts of the current context by ones for `scale`. The renderer's font texture is
/// then out of date.
Fonts load_fonts(float scale);

}  // namespace bspview
