#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/eval/commands.h"
#include "app/eval/progress.h"
#include "app/options/sampling_options.h"
#include "app/options/values.h"
#include "core/base/timer.h"
#include "core/eval/report.h"
#include "core/render/accelerator.h"
#include "core/render/heatmap.h"
#include "core/render/image_io.h"
#include "core/render/lazy_tree.h"
#include "core/render/lazy_walk.h"
#include "core/scene/load.h"

namespace bspview {
namespace {

struct RenderOptions {
  TreeOptions tree;
  RenderParams render;
  SamplingOptions sampling;
  std::optional<PictureSize> size;  // nullopt: that of the scene's camera
  std::optional<Heat> heat;
  bool reference = false;
  int repeats = 1;
  std::string output;
  std::string json;
  bool quiet = false;
};

RenderParams picture_params(const RenderOptions& options, const Camera& camera) {
  RenderParams params = options.render;
  if (options.sampling.samples) params.samples = *options.sampling.samples;
  params.adaptive = options.sampling.adaptive;
  params.cutoff = options.sampling.cutoff;
  params.width = options.size ? options.size->width : camera.width;
  params.height = options.size ? options.size->height : camera.height;
  params.traversal = options.tree.traversal;
  params.threads = options.tree.build.threads;
  return params;
}

Result<void> print_report(const Report& report, const std::string& json) {
  if (!json.empty()) {
    if (const auto written = write_output(json, to_json(report)); !written) return written;
  }
  return json == "-" ? Result<void>() : write_output("-", to_text(report));
}

Result<void> save_heat(const World& world, const RenderOptions& options) {
  const Camera& camera = world.scene.camera;
  const auto map = measure_heat(world, camera, picture_params(options, camera), *options.heat);
  if (!map) return map.error();
  const HeatRange range = heat_range(*map);
  if (const auto saved = save_image(color_heat(*map, range, ColorMap::viridis), options.output);
      !saved) {
    return saved;
  }
  fmt::print(stderr, "heat map: {} of the eye ray, viridis from {} to {}, largest {}\n",
             name_of(*options.heat), range.low, range.high, range.largest);
  return {};
}

LambdaParams lambda_params(const RenderOptions& options) {
  LambdaParams repeats;
  if (!options.tree.build.lazy) repeats.build_repeats = options.repeats;
  repeats.render_repeats = options.repeats;
  repeats.replay_repeats = std::max(repeats.replay_repeats, options.repeats);
  return repeats;
}

/// A bar that is full after `pictures` pictures, and what moves it.
class PictureProgress {
 public:
  PictureProgress(const RenderOptions& options, int pictures)
      : progress_("pictures", pictures, Progress::mode(options.quiet)) {
    watch_.progress = [this](double more) { progress_.add(more); };
  }
  const Watch& watch() const { return watch_; }

 private:
  Progress progress_;
  Watch watch_;
};

/// The picture by brute force: no tree, so no Delta; T_TR is the time of this picture.
Result<Report> reference_report(const Scene& scene, const RenderOptions& options) {
  const RenderParams params = picture_params(options, scene.camera);
  PictureProgress progress(options, 1);
  const Timer timer;
  const auto image = render_reference(scene, scene.camera, params, progress.watch());
  const double seconds = timer.seconds();
  if (!image) return image.error();
  if (const auto saved = save_image(*image, options.output); !saved) return saved.error();
  Report report(scene);
  report.lambda = Lambda{.t_cb = {}, .t_tr = summarise({seconds}), .t_tt_share = {}};
  return report;
}

Result<void> run_reference(const RenderOptions& options) {
  const Result<Scene> scene = load_scene(options.tree.scene);
  if (!scene) return scene.error();
  const Result<Report> report = reference_report(*scene, options);
  return report ? print_report(*report, options.json) : report.error();
}

/// Makes the picture, saves it unless a heat map takes its place, then measures.
Result<Report> picture_report(const World& world, const RenderOptions& options) {
  const Camera& camera = world.scene.camera;
  const RenderParams params = picture_params(options, camera);
  const LambdaParams repeats = lambda_params(options);
  PictureProgress progress(options, 1 + planned_runs(params, repeats));

  const auto counted = render_counted(world, camera, params, progress.watch());
  if (!counted) return counted.error();
  if (!options.heat) {
    const auto saved = save_image(counted->image, options.output);
    if (!saved) return saved.error();
  }
  const auto lambda = measure_lambda(world, camera, params, repeats, progress.watch());
  if (!lambda) return lambda.error();

  Report report(world.scene);
  report.seed = options.tree.seed;
  report.tree = TreeReport(world.tree, options.tree.traversal);
  report.rays = counted->counts;
  report.samples_per_pixel = static_cast<double>(counted->counts.primary) /
                             static_cast<double>(counted->image.pixels.size());
  report.delta = compute_delta(report.tree->stats, report.objects.objects, counted->counts);
  report.lambda = *lambda;
  return report;
}

/// A tree that grew, and what that took.
struct Grown {
  std::shared_ptr<const LazyTree> lazy;
  Tree tree;
  double build_seconds = 0.0;  // of the parts that the first picture needed, and the upper one
  double first_picture_seconds = 0.0;
};

Result<Grown> grow_tree(const Scene& scene, const RenderOptions& options) {
  const RenderParams params = picture_params(options, scene.camera);
  PictureProgress progress(options, 2);
  const Timer timer;
  const auto lazy = LazyTree::build(scene, options.tree.build);
  if (!lazy) return lazy.error();
  const World world = (*lazy)->world();
  const auto image = render_image(world, scene.camera, params, progress.watch());
  if (!image) return image.error();
  Grown grown{.lazy = *lazy, .first_picture_seconds = timer.seconds()};
  grown.build_seconds = (*lazy)->build_seconds() + (*lazy)->part_seconds();
  if (const auto built = build_for_counts(world, scene.camera, params, progress.watch()); !built) {
    return built.error();
  }
  Result<Tree> tree = (*lazy)->graft();
  if (!tree) return tree.error();
  grown.tree = *std::move(tree);
  return grown;
}

Result<void> run_lazily(const RenderOptions& options) {
  const Result<Scene> scene = load_scene(options.tree.scene);
  if (!scene) return scene.error();
  const Result<Grown> grown = grow_tree(*scene, options);
  if (!grown) return grown.error();
  const World world{*scene, grown->tree, grown->lazy->world().accelerator};
  if (options.heat) {
    if (const auto saved = save_heat(world, options); !saved) return saved;
  }
  Result<Report> report = picture_report(world, options);
  if (!report) return report.error();
  report->first_picture_seconds = grown->first_picture_seconds;
  report->lambda->t_cb = summarise({grown->build_seconds});
  return print_report(*report, options.json);
}

Result<void> run_with_tree(const RenderOptions& options) {
  const Result<SceneAndTree> built = load_and_build(options.tree, Progress::mode(options.quiet));
  if (!built) return built.error();
  if (options.heat) {
    const auto saved = save_heat({built->scene, built->tree}, options);
    if (!saved) return saved;
  }
  const FastWorld fast({built->scene, built->tree});
  const Result<Report> report = picture_report(fast.world(), options);
  return report ? print_report(*report, options.json) : report.error();
}

Result<void> run_render(const RenderOptions& options) {
  for (const std::string& file : {options.output, options.json}) {
    if (const auto ready = check_output(file); !ready) return ready;
  }
  if (options.reference) return run_reference(options);
  return options.tree.build.lazy ? run_lazily(options) : run_with_tree(options);
}

std::string check_image_name(const std::string& file) {
  if (is_image_name(file)) return "";
  return fmt::format("'{}' ends neither in .png nor in .exr", file);
}

void set_heat(const std::string& name, std::optional<Heat>& heat) {
  const auto found = std::ranges::find(heat_names(), name);
  if (found == heat_names().end()) {
    throw CLI::ValidationError(
        "--heat", fmt::format("'{}' is none of {}", name, fmt::join(heat_names(), ", ")));
  }
  heat = static_cast<Heat>(found - heat_names().begin());
}

void add_picture_options(CLI::App& command, RenderOptions& options) {
  add_picture_size(command, "--size", options.size)
      ->description("Pixels; default: as the scene's view says");
  add_sampling_options(command, options.sampling, RenderParams{}.samples);
  add_arithmetic_options(command, options.render.arithmetic, options.render.offset);
  command
      .add_option("--max-ray-depth", options.render.max_ray_depth,
                  "Levels of rays; the eye ray is level 1")
      ->check(CLI::Range(1, 64).description(""))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_flag("--spd-rules", options.render.spd_rules,
                "Rays through pixel corners, one-sided objects, every secondary ray")
      ->excludes("--spp")
      ->excludes("--adaptive")
      ->excludes("--cutoff");
  command.add_option("--repeat", options.repeats, "Measure T_CB and T_TR at least N times")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--heat", [&options](const std::string& name) { set_heat(name, options.heat); },
          "Write what each eye ray cost instead of what it saw")
      ->type_name(fmt::format("{}", fmt::join(heat_names(), "|")));
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command =
      add_command(app, "render", "Makes a picture and measures Delta and Lambda", options->quiet);
  add_scene(*command, options->tree.scene)->required();
  add_tree_options(*command, options->tree);
  add_output(*command, options->output, "Picture to write, .png or .exr")
      ->check(CLI::Validator(check_image_name, ""));
  add_picture_options(*command, *options);
  command
      ->add_flag("--reference", options->reference,
                 "Without a tree: every object for every ray, in double precision")
      ->excludes("--heat")
      ->excludes("--builder")
      ->excludes("--traversal")
      ->excludes("--lazy")
      ->excludes("--arithmetic");
  add_json(*command, options->json);
  command->callback([options, &run] {
    check_lazy(options->tree);
    if (options->tree.build.lazy && options->render.arithmetic != Arithmetic::exact)
      throw CLI::ValidationError("--lazy", "a tree that grows is met by --arithmetic exact only");
    if (options->json == options->output)
      throw CLI::ValidationError("--json", "'" + options->json + "' is where the picture goes");
    run = [options] { return run_render(*options); };
  });
}

}  // namespace bspview
