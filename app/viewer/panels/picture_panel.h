#pragma once

#include "app/viewer/panels/ui.h"
#include "app/viewer/state.h"

namespace bspview {

/// How many rays the picture is made of.
void picture_panel(const Ui& ui, State& state);

}  // namespace bspview
