#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"
#include "app/viewer/state.h"

namespace bspview {

/// The rays of the picked pixel, and the steps of the selected one through the tree.
void ray_panel(const Ui& ui, const Results& results, State& state);

}  // namespace bspview
