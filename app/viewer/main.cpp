#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/options/command_line.h"
#include "app/viewer/run_offscreen.h"
#include "app/viewer/viewer_options.h"

namespace {

int report(const bspview::Result<void>& result) {
  if (result) return bspview::exit_done;
  fmt::print(stderr, "bspview: {}\n", result.error().message);
  return bspview::exit_failed;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("bspview: shows how rays walk the BSP tree of a scene");
  app.set_version_flag("--version", "bspview " BSPVIEW_VERSION);
  bspview::ViewerOptions options;
  add_viewer_options(app, options);
  if (const auto code = bspview::parse_command_line(app, argc, argv)) return *code;
  bspview::State state;
  apply_options(options, state);
  return report(run_screenshot(options, state));
}
