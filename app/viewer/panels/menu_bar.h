#pragma once

#include <vector>

#include "app/viewer/actions.h"
#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"

namespace bspview {

/// The menus, made from the table of keys; what was chosen is added to `actions`.
void menu_bar(const Ui& ui, const Results& results, const State& state,
              std::vector<Action>& actions);

}  // namespace bspview
