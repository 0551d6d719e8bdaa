#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "app/eval/commands.h"
#include "app/options/command_line.h"

namespace {

int run_program(int argc, char** argv) {
  using namespace bspview;
  CLI::App app("Evaluates BSP trees for ray tracing", "bspeval");
  app.set_version_flag("--version", "bspeval " BSPVIEW_VERSION);
  app.require_subcommand(1);
  Run run;
  add_stats(app, run);
  add_render(app, run);
  add_cast(app, run);
  add_spd(app, run);
  add_bench(app, run);
  add_stress(app, run);
  add_error(app, run);
  add_tune(app, run);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;

  const Result<void> result = run();
  if (result) return exit_done;
  fmt::print(stderr, "bspeval: {}\n", result.error().message);
  return exit_failed;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("bspeval: there is not enough memory\n", stderr);
    return bspview::exit_failed;
  }
}
