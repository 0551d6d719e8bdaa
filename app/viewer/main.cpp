#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "app/options/command_line.h"
#include "app/viewer/run_offscreen.h"
#include "app/viewer/run_window.h"
#include "app/viewer/settings.h"
#include "app/viewer/viewer_options.h"

namespace {

using namespace bspview;

/// Screenshots and scripts are the same for everyone: they take nothing from the user's settings.
Result<void> run(const ViewerOptions& options) {
  State state;
  if (!options.screenshot.empty() || !options.script.empty()) {
    apply_options(options, state);
    return options.script.empty() ? run_screenshot(options, std::move(state))
                                  : run_script(options, std::move(state));
  }
  const std::filesystem::path file = settings_file();
  Settings settings = load_settings(file);
  apply_settings(settings, state);
  apply_options(options, state);
  const Result<void> result = run_window(options, std::move(state), settings);
  if (result) (void)save_settings(settings, file);
  return result;
}

int run_program(int argc, char** argv) {
  CLI::App app("Shows how rays walk the BSP tree of a scene", "bspview");
  app.set_version_flag("--version", "bspview " BSPVIEW_VERSION);
  ViewerOptions options;
  add_viewer_options(app, options);
  if (const auto code = parse_command_line(app, argc, argv)) return *code;
  const Result<void> result = run(options);
  if (result) return exit_done;
  fmt::print(stderr, "bspview: {}\n", result.error().message);
  return exit_failed;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("bspview: there is not enough memory\n", stderr);
    return bspview::exit_failed;
  }
}
