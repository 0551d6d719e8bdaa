#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/eval/commands.h"
#include "core/scene/load.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

struct SpdOptions {
  std::string name;
  std::optional<int> size;
  std::string output;
  bool quiet = false;
};

std::vector<std::string> spd_names() {
  std::vector<std::string> names;
  for (const SpdScene& scene : spd_scenes()) names.emplace_back(scene.name);
  return names;
}

std::string check_name(const std::string& name) {
  const std::vector<std::string> names = spd_names();
  if (std::ranges::find(names, name) != names.end()) return "";
  return fmt::format("'{}' is none of {}", name, fmt::join(names, ", "));
}

Result<void> run_spd(const SpdOptions& options) {
  if (const auto ready = check_output(options.output); !ready) return ready;
  const Result<Scene> scene = make_spd(options.name, options.size);
  if (!scene) return scene.error();
  return write_output(options.output, format_nff(*scene));
}

}  // namespace

void add_spd(CLI::App& app, Run& run) {
  const auto options = std::make_shared<SpdOptions>();
  CLI::App* command = add_command(app, "spd", "Writes a scene of the Standard Procedural Databases",
                                  options->quiet);
  command->add_option("NAME", options->name, fmt::format("{}", fmt::join(spd_names(), ", ")))
      ->check(CLI::Validator(check_name, ""))
      ->type_name("")
      ->required();
  command->add_option("SIZE", options->size, "Size factor; default: the published scene's")
      ->type_name("");
  add_output(*command, options->output, "NFF file to write; - is stdout");
  command->callback([options, &run] { run = [options] { return run_spd(*options); }; });
}

}  // namespace bspview
