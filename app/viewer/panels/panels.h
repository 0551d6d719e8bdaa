#pragma once

#include <vector>

#include "app/viewer/actions.h"
#include "app/viewer/layout.h"
#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"

namespace bspview {

/// The regions for `window` (in the units of the cursor) as `state` wishes them.
Layout layout_for(const Ui& ui, Vec2 window, const State& state);

/// Draws the whole interface of one frame, picture excepted. Edits `state`; adds to `actions` what
/// the menus were asked for.
void draw_panels(const Ui& ui, Vec2 window, const Results& results, State& state,
                 std::vector<Action>& actions);

}  // namespace bspview
