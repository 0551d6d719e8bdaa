#pragma once

#include "app/viewer/settings.h"
#include "app/viewer/viewer_options.h"
#include "core/base/result.h"

namespace bspview {

/// Opens the window and serves it until it is closed. Leaves what is to be kept in `settings`.
Result<void> run_window(const ViewerOptions& options, State state, Settings& settings);

}  // namespace bspview
