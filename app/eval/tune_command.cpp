#include <memory>

#include "app/eval/commands.h"
#include "app/eval/progress.h"
#include "app/options/values.h"
#include "core/eval/bench/tune.h"

namespace bspview {
namespace {

struct TuneOptions {
  TreeOptions tree;
  std::vector<std::string> scenes{"spd:balls", "spd:gears",  "spd:lattice", "spd:mount",
                                  "spd:rings", "spd:teapot", "spd:tetra",   "spd:tree"};
  TuneParams params;
  std::string json;
  bool quiet = false;
};

Result<void> run_tune_command(const TuneOptions& options) {
  if (const auto ready = check_output(options.json); !ready) return ready;
  const auto scenes = load_scenes(options.scenes);
  if (!scenes) return scenes.error();
  TuneParams params = options.params;
  params.bench.build = options.tree.build;
  params.bench.seed = options.tree.seed;
  const auto report = [&] {
    Progress progress("scenes", 1.0, Progress::mode(options.quiet));
    Watch watch;
    watch.progress = [&](double more) { progress.add(more); };
    return run_tune(*scenes, params, watch);
  }();
  if (!report) return report.error();
  if (!options.json.empty()) {
    if (const auto written = write_output(options.json, to_json(*report)); !written) return written;
  }
  return options.json == "-" ? Result<void>() : write_output("-", to_text(*report));
}

}  // namespace

void add_tune(CLI::App& app, Run& run) {
  const auto options = std::make_shared<TuneOptions>();
  CLI::App* command = add_command(
      app, "tune",
      "Times rays through trees with other costs, depths and leaf sizes, and fits the costs",
      options->quiet);
  command
      ->add_option("SCENE", options->scenes,
                   "Scene files, or spd:NAME[:SIZE]; default: the eight classic scenes")
      ->type_name("");
  add_tree_options(*command, options->tree);
  command->remove_option(command->get_option("--traversal"));  // the fast walk is tuned for
  command->get_option("--threads")->description("Threads that build; one is timed");
  BenchParams& bench = options->params.bench;
  command->add_option("--rays", bench.rays, "About so many rays of every kind a scene")
      ->transform(whole_number(1, 100000000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--repeat", bench.repeats, "Time everything N times, interleaved")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--costs", options->params.costs,
                   "What the C_I of each kind of object is tried with")
      ->delimiter(',')
      ->check(finite_number(1e-6, 1e6))
      ->type_name("F[,F]");
  add_json(*command, options->json);
  command->callback([options, &run] { run = [options] { return run_tune_command(*options); }; });
}

}  // namespace bspview
