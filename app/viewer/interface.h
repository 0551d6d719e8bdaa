#pragma once

#include <imgui.h>

#include "app/viewer/fonts.h"
#include "app/viewer/input_queue.h"
#include "app/viewer/theme.h"
#include "app/viewer/window_size.h"

namespace bspview {

/// A Dear ImGui context with our fonts, looks and input; draws nothing by itself and needs no
/// window, so that tests run the panels in it.
class Interface {
 public:
  Interface();
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Fonts are made anew only when `scale` changed.
  void set_look(Theme theme, float scale);
  /// Counts the fonts' changes: a renderer has to upload them anew.
  int font_generation() const { return font_generation_; }

  void begin_frame(const WindowSize& size, float seconds_since_last);
  ImDrawData* end_frame();

  InputQueue& input() { return input_; }
  const Fonts& fonts() const { return fonts_; }
  const Palette& palette() const { return palette_; }
  float scale() const { return scale_; }

 private:
  ImGuiContext* context_;
  InputQueue input_;
  Fonts fonts_;
  Palette palette_;
  Theme theme_ = Theme::dark;
  float scale_ = 0.0f;
  int font_generation_ = 0;
};

}  // namespace bspview
