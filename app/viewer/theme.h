#pragma once

#include <imgui.h>

#include <cstdint>

namespace bspview {

enum class Theme : std::uint8_t { dark, light };

/// The colours that the panels use beside Dear ImGui's own. Every text colour has a contrast of at
/// least 4.5 : 1 to `panel` and `field`.
struct Palette {
  ImVec4 window;  ///< behind the picture
  ImVec4 panel;   ///< behind the widgets
  ImVec4 field;   ///< of widgets
  ImVec4 line;    ///< separators and borders
  ImVec4 text, dim_text;
  ImVec4 accent;                  ///< what is selected or dragged
  ImVec4 on_accent;               ///< text on it
  ImVec4 better, worse, problem;  ///< text: a number fell, rose; an error
};
Palette palette_of(Theme theme);

/// Sets colours and sizes of the current Dear ImGui context, for text and widgets at `scale`.
void apply_theme(Theme theme, float scale);

/// Contrast of two opaque colours after WCAG 2.1, from 1 to 21.
float contrast(const ImVec4& a, const ImVec4& b);

}  // namespace bspview
