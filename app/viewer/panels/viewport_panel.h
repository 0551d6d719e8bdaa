#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"
#include "app/viewer/state.h"

namespace bspview {

/// The mouse over the picture: pick, turn, move, zoom. The picture itself is not drawn here.
void viewport_panel(const Ui& ui, const Rect& rect, const Results& results, State& state);

}  // namespace bspview
