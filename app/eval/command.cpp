#include "app/eval/command.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "core/base/file.h"
#include "core/render/lazy_tree.h"
#include "core/scene/load.h"

namespace bspview {
namespace {

/// All there is of a tree that grows before rays come.
Result<Tree> upper_part(const Scene& scene, const BuildParams& params) {
  const auto lazy = LazyTree::build(scene, params);
  return lazy ? (*lazy)->graft() : lazy.error();
}

}  // namespace

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      bool& quiet) {
  CLI::App* command = app.add_subcommand(name, description);
  command->set_version_flag("--version", "bspeval " BSPVIEW_VERSION);
  command->add_flag("-q,--quiet", quiet, "No progress on stderr");
  return command;
}

void add_json(CLI::App& command, std::string& file) {
  command.add_option("--json", file, "Write the results as one JSON object; - is stdout")
      ->type_name("FILE|-");
}

CLI::Option* add_output(CLI::App& command, std::string& file, const std::string& description) {
  return command.add_option("-o", file, description)->type_name("FILE")->required();
}

Result<void> write_output(const std::string& file, std::string_view bytes) {
  if (file != "-") return write_file(file, bytes);
  const std::size_t written = std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  if (written == bytes.size() && std::fflush(stdout) == 0) return {};
  return Error{fmt::format("standard output: cannot be written: {}", std::strerror(errno))};
}

Result<void> check_output(const std::string& file) {
  if (file.empty() || file == "-") return {};
  return check_writable(file);
}

Result<void> make_folder(const std::string& folder, const std::string& file) {
  if (folder.empty()) return {};
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Error{folder + ": cannot be made a folder: " + error.message()};
  return check_writable(std::filesystem::path(folder) / file);
}

Result<std::vector<Scene>> load_scenes(const std::vector<std::string>& names) {
  std::vector<Scene> scenes;
  for (const std::string& name : names) {
    Result<Scene> scene = load_scene(name);
    if (!scene) return scene.error();
    scenes.push_back(*std::move(scene));
  }
  return scenes;
}

Result<Tree> build_with_progress(const Scene& scene, const BuildParams& params,
                                 Progress::Mode mode) {
  const auto objects = static_cast<double>(scene.objects.size());
  Progress progress("tree", objects, mode);
  Watch watch;
  watch.progress = [&](double more) { progress.add(more * objects); };
  return build_scene_tree(scene, params, watch);
}

Result<SceneAndTree> load_and_build(const TreeOptions& options, Progress::Mode mode) {
  Result<Scene> scene = load_scene(options.scene);
  if (!scene) return scene.error();
  Result<Tree> tree = options.build.lazy ? upper_part(*scene, options.build)
                                         : build_with_progress(*scene, options.build, mode);
  if (!tree) return tree.error();
  return SceneAndTree{*std::move(scene), *std::move(tree)};
}

}  // namespace bspview
