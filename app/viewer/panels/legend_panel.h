#pragma once

#include <span>

#include "app/viewer/layout.h"
#include "app/viewer/overlays/legend.h"
#include "app/viewer/panels/ui.h"
#include "core/render/render.h"

namespace bspview {

// Legends stand in the lower left corner of a rectangle, in the current window. Each answers what
// it leaves of the rectangle, above it.

/// A colour bar with its ticks.
Rect legend_panel(const Ui& ui, const Rect& rect, const Legend& legend);

/// What the colours of a picked pixel's rays and their cells say.
Rect path_legend(const Ui& ui, const Rect& rect, std::span<const PathRay> rays);

}  // namespace bspview
