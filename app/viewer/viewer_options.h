#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "app/options/sampling_options.h"
#include "app/options/tree_options.h"
#include "app/viewer/picking.h"
#include "app/viewer/state.h"
#include "app/viewer/window_size.h"

namespace bspview {

/// The command line of bspview.
struct ViewerOptions {
  TreeOptions tree;
  std::string screenshot;     ///< file; "": open a window
  int width = 0, height = 0;  ///< of the window; 0: as it was left, or the standard size
  std::optional<Pixel> pick;
  std::optional<bool> panels, boxes, check;
  Arithmetic arithmetic = Arithmetic::exact;
  OffsetRule offset = OffsetRule::error_bounded;
  SamplingOptions sampling;
  std::optional<Theme> theme;
  std::optional<float> scale;
  std::string ui_map, state, script;  ///< files; "": none
};

void add_viewer_options(CLI::App& app, ViewerOptions& options);

/// `state` with everything that was asked for on the command line.
void apply_options(const ViewerOptions& options, State& state);

}  // namespace bspview
