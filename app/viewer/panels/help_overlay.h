#pragma once

#include "app/viewer/layout.h"
#include "app/viewer/panels/ui.h"

namespace bspview {

/// All keys and mouse gestures, in the middle of `window`. False when it was closed.
[[nodiscard]] bool help_overlay(const Ui& ui, const Rect& window);

}  // namespace bspview
