#include <algorithm>
#include <limits>
#include <memory>

#include "app/eval/commands.h"
#include "app/eval/progress.h"
#include "app/options/values.h"
#include "core/base/file.h"
#include "core/eval/bench/build_run.h"
#include "core/eval/bench/first_picture.h"
#include "core/eval/bench/povray.h"
#include "core/eval/bench/report.h"
#include "core/eval/bench/scale.h"
#include "core/scene/load.h"
#include "core/scene/spd.h"
#include "core/scene/triangulate.h"

namespace bspview {
namespace {

/// The classic scenes of the Standard Procedural Databases, and four larger ones.
const std::vector<std::string> standard_scenes{
    "spd:balls", "spd:gears", "spd:lattice", "spd:mount",     "spd:rings",   "spd:teapot",
    "spd:tetra", "spd:tree",  "spd:mount:8", "spd:teapot:40", "spd:tetra:8", "spd:balls:5"};

struct BenchOptions {
  TreeOptions tree;
  std::vector<std::string> scenes;
  BenchParams params;
  std::vector<std::string> kinds;
  std::string folder;
  std::string json;
  bool scale = false;
  bool povray = false;
  bool build = false;
  bool quality = false;
  bool first_picture = false;
  bool builder_given = false, limit_given = false;
  std::vector<double> sizes = BuildBenchParams{}.sizes;
  double max_objects = ScaleParams{}.max_objects;
  bool quiet = false;
};

BenchParams bench_params(const BenchOptions& options) {
  BenchParams params = options.params;
  params.build = options.tree.build;
  params.seed = options.tree.seed;
  if (options.kinds.empty()) return params;
  params.kinds.clear();
  for (std::size_t i = 0; i < bench_kind_count; ++i) {
    const auto kind = static_cast<BenchKind>(i);
    if (std::ranges::find(options.kinds, name_of(kind)) != options.kinds.end()) {
      params.kinds.push_back(kind);
    }
  }
  return params;
}

/// What there is to save of a report.
struct Texts {
  std::string text, json;
  std::vector<std::pair<std::string, std::string>> files;  // name in the folder, content
};

Texts texts_of(const BenchReport& report) {
  const std::string json = to_json(report);
  return {to_text(report),
          json,
          {{"bench.csv", to_csv(report)}, {"bench.json", json}, {"bench.svg", to_svg(report)}}};
}

Texts texts_of(const ScaleReport& report) {
  const std::string json = to_json(report);
  return {to_text(report),
          json,
          {{"scale.csv", to_csv(report)}, {"scale.json", json}, {"scale.svg", to_svg(report)}}};
}

Texts texts_of(const BuildReport& report) {
  const std::string json = to_json(report);
  return {to_text(report),
          json,
          {{"build.csv", to_csv(report)}, {"build.json", json}, {"build.svg", to_svg(report)}}};
}

Result<void> save(const Texts& texts, const BenchOptions& options) {
  if (!options.folder.empty()) {
    for (const auto& [name, text] : texts.files) {
      const auto written = write_file(std::filesystem::path(options.folder) / name, text);
      if (!written) return written;
    }
  }
  if (!options.json.empty()) {
    if (const auto written = write_output(options.json, texts.json); !written) return written;
  }
  return options.json == "-" ? Result<void>() : write_output("-", texts.text);
}

Texts texts_of(const PovrayReport& report) {
  const std::string json = to_json(report);
  return {to_text(report), json, {{"povray.csv", to_csv(report)}, {"povray.json", json}}};
}

Texts texts_of(const FirstPictureReport& report) {
  const std::string json = to_json(report);
  return {
      to_text(report), json, {{"first_picture.csv", to_csv(report)}, {"first_picture.json", json}}};
}

constexpr std::size_t classic_scenes = 8;  // of standard_scenes

Result<Texts> measure_pictures(const BenchOptions& options, const Watch& watch) {
  std::vector<std::string> names = options.scenes;
  if (names.empty())
    names.assign(standard_scenes.begin(), standard_scenes.begin() + classic_scenes);
  const auto scenes = load_scenes(names);
  if (!scenes) return scenes.error();
  const PovrayParams params{.build = options.tree.build, .repeats = options.params.repeats};
  const auto report = run_povray(*scenes, params, watch);
  return report ? Result<Texts>(texts_of(*report)) : report.error();
}

Result<Texts> measure_scale(const BenchOptions& options, const Watch& watch) {
  ScaleParams params{.bench = bench_params(options), .max_objects = options.max_objects};
  params.thread_objects = std::min(params.thread_objects, params.max_objects);
  const auto report = run_scale(params, watch);
  return report ? Result<Texts>(texts_of(*report)) : report.error();
}

Result<Texts> measure_builds(const BenchOptions& options, const Watch& watch) {
  BuildBenchParams params{.build = options.tree.build};
  params.sizes = options.sizes;
  params.repeats = options.params.repeats;
  // A tree that does not fit is built several times: no time of one build.
  if (!options.limit_given) params.build.memory_limit = std::numeric_limits<std::size_t>::max();
  if (options.builder_given) params.builders = {options.tree.build.builder};
  params.rays = options.params.rays;
  if (options.quality) {
    auto scenes = load_scenes(options.scenes.empty() ? standard_scenes : options.scenes);
    if (!scenes) return scenes.error();
    params.scenes = *std::move(scenes);
  }
  const auto report = run_build_bench(params, watch);
  return report ? Result<Texts>(texts_of(*report)) : report.error();
}

/// Half a million triangles, polygons of many corners, and four million triangles.
const std::vector<std::string> large_scenes{"spd:mount:9", "spd:gears:9", "spd:tetra:11"};

Result<Texts> measure_first_pictures(const BenchOptions& options, const Watch& watch) {
  const auto scenes = load_scenes(options.scenes.empty() ? large_scenes : options.scenes);
  if (!scenes) return scenes.error();
  FirstPictureParams params{.build = options.tree.build, .repeats = options.params.repeats};
  if (!options.limit_given) params.build.memory_limit = std::numeric_limits<std::size_t>::max();
  const auto report = run_first_picture(*scenes, params, watch);
  return report ? Result<Texts>(texts_of(*report)) : report.error();
}

Result<Texts> measure(const BenchOptions& options, const Watch& watch) {
  if (options.scale) return measure_scale(options, watch);
  if (options.build) return measure_builds(options, watch);
  if (options.povray) return measure_pictures(options, watch);
  if (options.first_picture) return measure_first_pictures(options, watch);
  const auto scenes = load_scenes(options.scenes.empty() ? standard_scenes : options.scenes);
  if (!scenes) return scenes.error();
  const auto report = run_bench(*scenes, bench_params(options), watch);
  return report ? Result<Texts>(texts_of(*report)) : report.error();
}

Result<void> run_bench_command(const BenchOptions& options) {
  if (const auto ready = check_output(options.json); !ready) return ready;
  if (const auto ready = make_folder(options.folder, "bench.svg"); !ready) return ready;
  const auto texts = [&] {
    Progress progress("scenes", 1.0, Progress::mode(options.quiet));
    Watch watch;
    watch.progress = [&](double more) { progress.add(more); };
    return measure(options, watch);
  }();
  return texts ? save(*texts, options) : texts.error();
}

std::string check_segments(const std::string& text) {
  return !text.empty() && (text.back() - '0') % 2 != 0 ? "segments: must be even" : "";
}

std::vector<std::string> kind_names() {
  return {bench_kind_names().begin(), bench_kind_names().end()};
}

void add_ray_options(CLI::App& command, BenchOptions& options) {
  BenchParams& params = options.params;
  command.add_option("--rays", params.rays, "About so many rays of every kind a scene")
      ->transform(whole_number(1, 100000000))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--kinds", options.kinds,
                  "Rays that are measured, of primary, shadow and scattered; default all")
      ->check(CLI::IsMember(kind_names()))
      ->delimiter(',')
      ->type_name("KIND[,KIND]");
  command
      .add_option("--segments", params.segments,
                  "Triangles around spheres and cones, even; 4 where there would be more than a "
                  "million triangles")
      ->check(CLI::Range(least_segments, 1000).description(""))
      ->check(CLI::Validator(check_segments, ""))
      ->type_name("N")
      ->capture_default_str();
}

void add_other_modes(CLI::App& command, BenchOptions& options) {
  CLI::Option* scale = command.add_flag(
      "--scale", options.scale,
      "Measure standard scenes in growing sizes, and threads from one to all, instead");
  for (const char* other : {"SCENE", "--segments"}) scale->excludes(command.get_option(other));
  command.add_option("--max-objects", options.max_objects, "With --scale: of the largest scenes")
      ->transform(whole_number(1000, static_cast<std::int64_t>(max_spd_objects)))
      ->needs(scale)
      ->type_name("N")
      ->default_str("1000000");
  CLI::Option* povray = command.add_flag(
      "--povray", options.povray,
      "Measure whole pictures beside POV-Ray instead; default: the eight classic scenes");
  povray->excludes(scale);
  for (const char* other : {"--rays", "--kinds", "--segments"}) {
    povray->excludes(command.get_option(other));
  }
}

void add_build_mode(CLI::App& command, BenchOptions& options) {
  CLI::Option* build = command.add_flag(
      "--build", options.build,
      "Time the building of standard scenes in growing sizes, with threads from one to all (or "
      "--threads), instead; default: every SAH builder, no memory limit");
  for (const char* other : {"--kinds", "--segments", "--scale", "--povray"}) {
    build->excludes(command.get_option(other));
  }
  CLI::Option* quality = command.add_flag("--quality", options.quality,
                                          "With --build: send rays through the trees of all its "
                                          "builders, too, of SCENE or the default");
  quality->needs(build);
  command
      .add_option("--sizes", options.sizes, "With --build: about so many objects, ascending or not")
      ->transform(whole_number(1, static_cast<std::int64_t>(max_spd_objects)))
      ->delimiter(',')
      ->needs(build)
      ->type_name("N[,N]")
      ->default_str("1e3,1e4,1e5,1e6");
}

/// Rays and scenes go with --build only where its trees are compared by them.
void check_quality(const BenchOptions& options, const CLI::App& command) {
  if (options.quality && options.tree.build.builder == Builder::naive) {
    throw CLI::ValidationError("--quality", "naive builds no tree");
  }
  if (!options.build || options.quality) return;
  for (const char* name : {"SCENE", "--rays"}) {
    if (command.count(name) > 0) {
      throw CLI::ValidationError(name, "goes with --build only where --quality is there");
    }
  }
}

void add_first_picture_mode(CLI::App& command, BenchOptions& options) {
  CLI::Option* first = command.add_flag(
      "--first-picture", options.first_picture,
      "Time the way from scenes to their first pictures instead: by whole trees, by a tree of "
      "--builder that grows where rays go, and by Embree; default: three large scenes");
  for (const char* other :
       {"--rays", "--kinds", "--segments", "--scale", "--povray", "--build", "--sizes"}) {
    first->excludes(command.get_option(other));
  }
}

void add_bench_options(CLI::App& command, BenchOptions& options) {
  command
      .add_option("SCENE", options.scenes,
                  "Scene files, or spd:NAME[:SIZE]; default: the eight classic scenes and four "
                  "larger ones")
      ->type_name("");
  add_tree_options(command, options.tree, "the kernels are measured in whole trees");
  command.remove_option(command.get_option("--traversal"));  // every peer has its own
  command.get_option("--threads")->description("Threads that build; one is timed");
  add_ray_options(command, options);
  command.add_option("--repeat", options.params.repeats, "Time everything N times, interleaved")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->capture_default_str();
  add_other_modes(command, options);
  add_build_mode(command, options);
  add_first_picture_mode(command, options);
  command
      .add_option(
          "-o", options.folder,
          "Folder for bench.csv, .json and .svg; those of scale or build; povray.csv, .json and "
          "those of first_picture")
      ->type_name("DIR");
  add_json(command, options.json);
}

}  // namespace

void add_bench(CLI::App& app, Run& run) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = add_command(
      app, "bench", "Measures the speed of tracing rays, beside Embree where it is there",
      options->quiet);
  add_bench_options(*command, *options);
  command->callback([options, command, &run] {
    check_quality(*options, *command);
    options->builder_given = command->count("--builder") > 0;
    options->limit_given = command->count("--memory-limit") > 0;
    if (options->first_picture && options->tree.build.builder == Builder::naive)
      throw CLI::ValidationError("--builder", "the builder naive splits nothing that could wait");
    run = [options] { return run_bench_command(*options); };
  });
}

}  // namespace bspview
