#pragma once

#include <imgui.h>

#include <string>

#include "app/viewer/fonts.h"
#include "app/viewer/theme.h"
#include "app/viewer/widget_map.h"

namespace bspview {

/// What every panel draws with.
struct Ui {
  const Fonts& fonts;
  const Palette& palette;
  float scale;         ///< pixels of the window for one pixel of the design
  bool tooltips;       ///< the pointer rests
  WidgetMap& widgets;  ///< takes down every widget of the frame

  float px(float design_pixels) const { return design_pixels * scale; }
  /// Takes down the last item as `name`.
  void note(const std::string& name) const;
};

}  // namespace bspview
