#pragma once

#include "app/viewer/layout.h"
#include "app/viewer/overlays/legend.h"
#include "app/viewer/panels/ui.h"

namespace bspview {

/// A colour bar with its ticks in the lower left corner of `rect`, in the current window.
void legend_panel(const Ui& ui, const Rect& rect, const Legend& legend);

}  // namespace bspview
