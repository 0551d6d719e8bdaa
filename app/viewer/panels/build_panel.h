#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"
#include "app/viewer/state.h"

namespace bspview {

/// How the tree is built and walked.
void build_panel(const Ui& ui, const Results& results, State& state);

}  // namespace bspview
