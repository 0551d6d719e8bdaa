#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"
#include "app/viewer/state.h"

namespace bspview {

/// The scene that is shown, and what else could be: a file or a standard scene with its size.
void scene_panel(const Ui& ui, const Results& results, State& state);

}  // namespace bspview
