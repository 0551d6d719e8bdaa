#include <array>
#include <filesystem>
#include <memory>

#include "app/eval/commands.h"
#include "app/eval/progress.h"
#include "core/base/file.h"
#include "core/eval/bench/report.h"
#include "core/scene/load.h"
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
  bool quiet = false;
};

Result<std::vector<Scene>> load_scenes(const std::vector<std::string>& names) {
  std::vector<Scene> scenes;
  for (const std::string& name : names.empty() ? standard_scenes : names) {
    Result<Scene> scene = load_scene(name);
    if (!scene) return scene.error();
    scenes.push_back(*std::move(scene));
  }
  return scenes;
}

Result<void> make_folder(const std::string& folder) {
  if (folder.empty()) return {};
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Error{folder + ": cannot be made a folder: " + error.message()};
  return check_writable(std::filesystem::path(folder) / "bench.svg");
}

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

Result<void> save(const BenchReport& report, const BenchOptions& options) {
  if (!options.folder.empty()) {
    const std::filesystem::path folder(options.folder);
    const std::pair<const char*, std::string> files[]{{"bench.csv", to_csv(report)},
                                                      {"bench.json", to_json(report)},
                                                      {"bench.svg", to_svg(report)}};
    for (const auto& [name, text] : files) {
      if (const auto written = write_file(folder / name, text); !written) return written;
    }
  }
  if (!options.json.empty()) {
    if (const auto written = write_output(options.json, to_json(report)); !written) return written;
  }
  return options.json == "-" ? Result<void>() : write_output("-", to_text(report));
}

Result<void> run_bench_command(const BenchOptions& options) {
  if (const auto ready = check_output(options.json); !ready) return ready;
  if (const auto ready = make_folder(options.folder); !ready) return ready;
  const auto scenes = load_scenes(options.scenes);
  if (!scenes) return scenes.error();
  const auto report = [&] {
    Progress progress("scenes", 1.0, options.quiet ? Progress::Mode::quiet : Progress::Mode::shown);
    Watch watch;
    watch.progress = [&](double more) { progress.add(more); };
    return run_bench(*scenes, bench_params(options), watch);
  }();
  if (!report) return report.error();
  return save(*report, options);
}

std::string check_segments(const std::string& text) {
  return !text.empty() && (text.back() - '0') % 2 != 0 ? "segments: must be even" : "";
}

std::vector<std::string> kind_names() {
  return {bench_kind_names().begin(), bench_kind_names().end()};
}

void add_bench_options(CLI::App& command, BenchOptions& options) {
  command
      .add_option("SCENE", options.scenes,
                  "Scene files, or spd:NAME[:SIZE]; default: the eight classic scenes and four "
                  "larger ones")
      ->type_name("");
  add_tree_options(command, options.tree);
  command.get_option("--threads")->description("Threads that build; one is timed");
  BenchParams& params = options.params;
  command.add_option("--rays", params.rays, "About so many rays of every kind a scene")
      ->check(CLI::Range(1, 100000000).description(""))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--repeat", params.repeats, "Time everything N times, interleaved")
      ->check(CLI::Range(1, 100000).description(""))
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
  command.add_option("-o", options.folder, "Folder for bench.csv, bench.json and bench.svg")
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
  command->callback([options, &run] { run = [options] { return run_bench_command(*options); }; });
}

}  // namespace bspview
