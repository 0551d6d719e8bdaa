#pragma once

#include "app/viewer/viewer_options.h"
#include "core/base/result.h"

namespace bspview {

/// Saves one converged frame without any window.
Result<void> run_screenshot(const ViewerOptions& options, State state);

/// Replays a script of input (script.h) without any window, on a clock of its own.
Result<void> run_script(const ViewerOptions& options, State state);

}  // namespace bspview
