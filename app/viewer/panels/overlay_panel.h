#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"
#include "app/viewer/state.h"

namespace bspview {

/// What is drawn over the picture.
void overlay_panel(const Ui& ui, const Results& results, State& state);

}  // namespace bspview
