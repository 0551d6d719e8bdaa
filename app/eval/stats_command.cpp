#include <memory>

#include "app/eval/commands.h"
#include "core/eval/histogram.h"
#include "core/eval/report.h"

namespace bspview {
namespace {

struct StatsOptions {
  TreeOptions tree;
  std::string json;
  bool quiet = false;
};

Result<void> run_stats(const StatsOptions& options) {
  if (const auto ready = check_output(options.json); !ready) return ready;
  const Result<SceneAndTree> built = load_and_build(options.tree, Progress::mode(options.quiet));
  if (!built) return built.error();

  Report report(built->scene);
  report.seed = options.tree.seed;
  report.tree = TreeReport(built->tree, options.tree.traversal);
  report.delta = compute_delta(report.tree->stats, report.objects.objects);
  report.lambda =
      Lambda{.t_cb = summarise({built->tree.build_seconds}), .t_tr = {}, .t_tt_share = {}};

  if (!options.json.empty()) {
    if (const auto written = write_output(options.json, to_json(report)); !written) return written;
  }
  if (options.json == "-") return {};
  return write_output("-", to_text(report) + "\n" +
                               format_bars(depth_bars(report.tree->stats), "depth") + "\n" +
                               format_bars(leaf_size_bars(report.tree->stats), "objects"));
}

}  // namespace

void add_stats(CLI::App& app, Run& run) {
  const auto options = std::make_shared<StatsOptions>();
  CLI::App* command = add_command(
      app, "stats", "Builds a tree and describes it: the tree half of Delta, T_CB, histograms",
      options->quiet);
  add_scene(*command, options->tree.scene)->required();
  add_tree_options(*command, options->tree);
  add_json(*command, options->json);
  command->callback([options, &run] {
    check_lazy(options->tree);
    run = [options] { return run_stats(*options); };
  });
}

}  // namespace bspview
