#pragma once

// What the sub-commands of bspeval share: options, and where results go.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/eval/progress.h"
#include "app/options/tree_options.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace bspview {

/// What the chosen sub-command does; the error is the sentence for stderr.
using Run = std::function<Result<void>()>;

/// Adds a sub-command with --version and --quiet.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      bool& quiet);

/// The option --json FILE|-.
void add_json(CLI::App& command, std::string& file);

/// The option -o, which has to be there.
CLI::Option* add_output(CLI::App& command, std::string& file, const std::string& description);

/// Writes to stdout for "-", else to the file (see write_file).
Result<void> write_output(const std::string& file, std::string_view bytes);

/// Whether write_output will find its place; for "" (no output asked for), yes.
Result<void> check_output(const std::string& file);

/// Makes the folder of -o, in which `file` can then be written; for "", nothing.
Result<void> make_folder(const std::string& folder, const std::string& file);

Result<std::vector<Scene>> load_scenes(const std::vector<std::string>& names);

struct SceneAndTree {
  Scene scene;
  Tree tree;
};
Result<SceneAndTree> load_and_build(const TreeOptions& options, Progress::Mode mode);

/// build_scene_tree with a bar.
Result<Tree> build_with_progress(const Scene& scene, const BuildParams& params,
                                 Progress::Mode mode);

}  // namespace bspview
