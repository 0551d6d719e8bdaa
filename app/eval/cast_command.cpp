#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "app/eval/commands.h"
#include "app/eval/progress.h"
#include "core/base/counted.h"
#include "core/base/file.h"
#include "core/base/timer.h"
#include "core/eval/cast.h"
#include "core/eval/lambda.h"
#include "core/render/accelerator.h"
#include "core/render/lazy_tree.h"
#include "core/scene/load.h"

namespace bspview {
namespace {

struct CastOptions {
  TreeOptions tree;
  std::string rays;
  std::string output;
  bool any = false;
  int repeats = 0;  // 0: once, without timing
  bool quiet = false;
};

Result<std::vector<Ray>> load_rays(const std::string& file) {
  const bool from_stdin = file == "-";
  const Result<std::string> text = read_file(from_stdin ? "/dev/stdin" : file);
  if (!text) return text.error();
  return parse_rays(*text, from_stdin ? "standard input" : file);
}

/// Results, and how long each repeat took.
struct TimedResults {
  std::vector<RayResult> results;
  std::vector<double> seconds;
};

CastParams cast_params(const CastOptions& options) {
  return {.query = options.any ? CastParams::Query::any : CastParams::Query::closest,
          .traversal = options.tree.traversal,
          .threads = options.tree.build.threads};
}

TimedResults cast_repeatedly(const World& world, std::span<const Ray> rays,
                             const CastOptions& options) {
  const CastParams params = cast_params(options);
  const int repeats = std::max(1, options.repeats);
  Progress progress("rays", static_cast<double>(rays.size()) * repeats,
                    Progress::mode(options.quiet));
  TimedResults timed;
  for (int i = 0; i < repeats; ++i) {
    const Timer timer;
    timed.results = cast_rays(world, rays, params,
                              [&](std::size_t done) { progress.add(static_cast<double>(done)); });
    timed.seconds.push_back(timer.seconds());
  }
  return timed;
}

void print_rate(std::size_t rays, std::span<const double> seconds, const std::string& kernel) {
  std::vector<double> rates;  // Mrays/s
  for (const double s : seconds) rates.push_back(static_cast<double>(rays) / 1e6 / s);
  const Measured rate = summarise(std::move(rates));
  fmt::print(stderr, "median {:.3f} Mrays/s of {}, spread {:.3f}, {}\n", rate.median,
             counted(rate.repeats, "repeat"), rate.spread, kernel);
}

/// A scene and what its rays go through.
struct Target {
  Scene scene;
  std::optional<Tree> tree;
  std::shared_ptr<const Accelerator> accelerator;
  std::shared_ptr<const LazyTree> lazy;

  World world() const { return lazy ? lazy->world() : World{scene, *tree, accelerator.get()}; }
};

Result<std::unique_ptr<Target>> make_target(const TreeOptions& options, Progress::Mode mode) {
  auto target = std::make_unique<Target>();
  Result<Scene> scene = load_scene(options.scene);
  if (!scene) return scene.error();
  target->scene = *std::move(scene);
  if (options.build.lazy) {
    auto lazy = LazyTree::build(target->scene, options.build);
    if (!lazy) return lazy.error();
    target->lazy = *std::move(lazy);
    return target;
  }
  Result<Tree> tree = build_with_progress(target->scene, options.build, mode);
  if (!tree) return tree.error();
  target->tree = *std::move(tree);
  target->accelerator = make_accelerator(target->world());
  return target;
}

Result<void> run_cast(const CastOptions& options) {
  if (const auto ready = check_output(options.output); !ready) return ready;
  const Result<std::vector<Ray>> rays = load_rays(options.rays);
  if (!rays) return rays.error();
  const auto target = make_target(options.tree, Progress::mode(options.quiet));
  if (!target) return target.error();

  const World world = (*target)->world();
  const TimedResults timed = cast_repeatedly(world, *rays, options);
  const auto written = write_output(options.output, options.any ? format_occlusion(timed.results)
                                                                : format_results(timed.results));
  if (!written) return written;
  if (options.repeats > 0) {
    print_rate(rays->size(), timed.seconds, cast_kernel(world, cast_params(options)));
  }
  return {};
}

}  // namespace

void add_cast(CLI::App& app, Run& run) {
  const auto options = std::make_shared<CastOptions>();
  CLI::App* command = add_command(app, "cast", "Traces rays from a file", options->quiet);
  add_scene(*command, options->tree.scene)->required();
  add_tree_options(*command, options->tree);
  command
      ->add_option(
          "--rays", options->rays,
          "Rays, one a line: ox oy oz dx dy dz [tmin tmax], # starts a comment; - is stdin")
      ->type_name("FILE")
      ->required();
  add_output(*command, options->output,
             "Results, one a line: object and t, -1 inf for a miss; - is stdout");
  command->add_flag("--any", options->any, "Occlusion: 1 for a ray that hits something, else 0");
  command
      ->add_option("--repeat", options->repeats,
                   "Trace N times and print the median rate on stderr")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N");
  command->callback([options, &run] {
    check_lazy(options->tree);
    run = [options] { return run_cast(*options); };
  });
}

}  // namespace bspview
