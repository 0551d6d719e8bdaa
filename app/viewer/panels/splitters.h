#pragma once

#include "app/viewer/layout.h"
#include "app/viewer/panels/ui.h"

namespace bspview {

/// The three borders between regions that can be dragged.
void splitters(const Ui& ui, const LayoutInput& input, const Layout& layout, Splits& splits);

}  // namespace bspview
