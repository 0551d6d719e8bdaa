#include <map>
#include <memory>

#include "app/eval/commands.h"
#include "app/eval/progress.h"
#include "app/options/values.h"
#include "core/base/file.h"
#include "core/eval/error/report.h"
#include "core/scene/load.h"

namespace bspview {
namespace {

/// The classic scenes of the Standard Procedural Databases.
const std::vector<std::string> standard_scenes{"spd:balls", "spd:gears", "spd:lattice",
                                               "spd:mount", "spd:rings", "spd:teapot",
                                               "spd:tetra", "spd:tree"};

/// What is measured.
enum class Parts { rays, both, images };
const std::map<std::string, Parts> parts_by_name{
    {"off", Parts::rays}, {"on", Parts::both}, {"only", Parts::images}};

struct ErrorOptions {
  TreeOptions tree;
  std::vector<std::string> scenes;
  std::size_t rays = ErrorParams{}.rays;
  int repeats = ErrorParams{}.repeats;
  std::optional<PictureSize> size;
  Parts parts = Parts::both;
  bool threads_given = false;
  std::string folder;
  std::string json;
  bool quiet = false;
};

int timing_threads(const ErrorOptions& options) {
  return options.threads_given ? options.tree.build.threads : 1;
}

ErrorParams error_params(const ErrorOptions& options) {
  ErrorParams params;
  params.build = options.tree.build;
  params.traversal = options.tree.traversal;
  params.seed = options.tree.seed;
  params.rays = options.rays;
  params.repeats = options.repeats;
  params.timing_threads = timing_threads(options);
  return params;
}

Result<void> measure_rays(const ErrorOptions& options, const Watch& watch, ErrorStudy& study) {
  const auto scenes = load_scenes(options.scenes.empty() ? standard_scenes : options.scenes);
  if (!scenes) return scenes.error();
  auto report = measure_errors(*scenes, error_params(options), watch);
  if (!report) return report.error();
  study.rays = *std::move(report);
  return {};
}

constexpr PictureSize default_size{128, 128};
/// Without a wish, these have their pictures measured: the others take long and say the same.
const std::vector<std::string> standard_pictures{"spd:balls", "spd:teapot"};

ImageErrorParams image_params(const ErrorOptions& options) {
  const PictureSize size = options.size.value_or(default_size);
  ImageErrorParams params;
  params.render.width = size.width;
  params.render.height = size.height;
  params.render.traversal = options.tree.traversal;
  params.render.threads = options.tree.build.threads;
  params.repeats = options.repeats;
  params.timing_threads = timing_threads(options);
  return params;
}

Result<void> measure_pictures(const ErrorOptions& options, const Watch& watch, ErrorStudy& study) {
  const std::vector<std::string>& names =
      options.scenes.empty() ? standard_pictures : options.scenes;
  for (const std::string& name : names) {
    TreeOptions tree = options.tree;
    tree.scene = name;
    const Result<SceneAndTree> built = load_and_build(tree, Progress::Mode::quiet);
    if (!built) return built.error();
    const Scene& scene = built->scene;
    SceneImageError image{scene.name, image_params(options), {}};
    Watch part(watch.stop);
    part.progress = [&](double more) { watch.advance(more / static_cast<double>(names.size())); };
    auto curves = measure_image_error({scene, built->tree}, scene.camera, image.params, part);
    if (!curves) return curves.error();
    image.curves = *std::move(curves);
    study.images.push_back(std::move(image));
  }
  return {};
}

/// Runs `work` under a bar that is full when its watch has been advanced by 1.
template <class Work>
Result<void> with_progress(const std::string& what, bool quiet, const Work& work) {
  Progress progress(what, 1.0, Progress::mode(quiet));
  Watch watch;
  watch.progress = [&](double more) { progress.add(more); };
  return work(watch);
}

Result<void> save(const ErrorStudy& study, const ErrorOptions& options) {
  if (!options.folder.empty()) {
    const std::filesystem::path folder(options.folder);
    std::map<std::string, std::string> files{{"error.json", to_json(study)},
                                             {"error.html", to_html(study)}};
    if (options.parts != Parts::images) files["error.csv"] = to_csv(study.rays);
    if (options.parts != Parts::rays) files["images.csv"] = to_csv(study.images);
    for (const auto& [name, text] : files) {
      if (const auto written = write_file(folder / name, text); !written) return written;
    }
  }
  if (!options.json.empty()) {
    if (const auto written = write_output(options.json, to_json(study)); !written) return written;
  }
  return options.json == "-" ? Result<void>() : write_output("-", to_text(study));
}

Result<void> run_error(const ErrorOptions& options) {
  if (const auto ready = check_output(options.json); !ready) return ready;
  if (const auto ready = make_folder(options.folder, "error.html"); !ready) return ready;
  ErrorStudy study;
  const auto rays = [&](const Watch& watch) { return measure_rays(options, watch, study); };
  const auto pictures = [&](const Watch& watch) { return measure_pictures(options, watch, study); };
  if (options.parts != Parts::images) {
    if (const auto done = with_progress("rays", options.quiet, rays); !done) return done;
  }
  if (options.parts != Parts::rays) {
    if (const auto done = with_progress("pictures", options.quiet, pictures); !done) return done;
  }
  return save(study, options);
}

}  // namespace

void add_error(CLI::App& app, Run& run) {
  const auto options = std::make_shared<ErrorOptions>();
  CLI::App* command = add_command(app, "error", "Measures run time against error", options->quiet);
  command
      ->add_option("SCENE", options->scenes,
                   "Scene files, or spd:NAME[:SIZE]; default: the eight classic scenes")
      ->type_name("");
  add_tree_options(*command, options->tree, "errors are measured in whole trees");
  CLI::Option* threads = command->get_option("--threads");
  threads->description("Threads that are timed; default 1. Building and judging use all cores")
      ->default_str("1");
  command->add_option("--rays", options->rays, "Rays of every kind a scene, all of them judged")
      ->transform(whole_number(1, 10000000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--repeat", options->repeats, "Time everything N times, interleaved")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--images", options->parts,
                   "Measure the error of pictures against time, too, or nothing else; default on: "
                   "of the scenes given, or of spd:balls and spd:teapot")
      ->transform(CLI::CheckedTransformer(parts_by_name).description(""))
      ->type_name("on|off|only");
  add_picture_size(*command, "--size", options->size)
      ->description("Pixels of those pictures; default 128x128");
  command
      ->add_option("-o", options->folder,
                   "Folder for error.html, error.json, error.csv and images.csv")
      ->type_name("DIR");
  add_json(*command, options->json);
  command->callback([options, threads, &run] {
    options->threads_given = threads->count() > 0;
    run = [options] { return run_error(*options); };
  });
}

}  // namespace bspview
