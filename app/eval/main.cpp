#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  CLI::App app("bspeval: evaluates BSP trees for ray tracing");
  app.set_version_flag("--version", "bspeval " BSPVIEW_VERSION);
  CLI11_PARSE(app, argc, argv);
  return 0;
}
