#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"
#include "app/viewer/state.h"

namespace bspview {

/// Delta and Lambda of the current setting beside those of the previous one.
void measures_panel(const Ui& ui, const Results& results, State& state);

}  // namespace bspview
