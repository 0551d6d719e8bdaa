#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"

namespace bspview {

/// How rays are computed, what of the picture is wrong, and run time against error.
void accuracy_panel(const Ui& ui, const Results& results, State& state);

}  // namespace bspview
