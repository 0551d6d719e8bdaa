#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/eval/commands.h"
#include "app/eval/progress.h"
#include "app/options/values.h"
#include "core/base/counted.h"
#include "core/eval/stress/stress.h"
#include "core/scene/load.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

struct StressOptions {
  std::string scene;
  stress::Plan plan;
  std::string json;
  bool quiet = false;
};

/// Where the checks run: on scenes of their own, then on those the user named. A trial that was
/// asked for by its number runs on the named scene alone.
std::vector<std::string> scene_names(const StressOptions& options) {
  std::vector<std::string> names;
  if (options.scene.empty() || !options.plan.only) names.push_back("");
  if (options.scene == "all") {
    for (const SpdScene& scene : spd_scenes()) names.push_back(fmt::format("spd:{}", scene.name));
  } else if (!options.scene.empty()) {
    names.push_back(options.scene);
  }
  return names;
}

Result<stress::NamedScene> load_named(const std::string& name) {
  if (name.empty()) return stress::NamedScene{};
  auto scene = load_scene(name);
  if (!scene) return scene.error();
  return stress::NamedScene{name, std::make_shared<Scene>(*std::move(scene))};
}

Result<std::vector<stress::Row>> run_on(const std::string& name, const StressOptions& options,
                                        Progress& progress) {
  const auto scene = load_named(name);
  if (!scene) return scene.error();
  Watch watch;
  watch.progress = [&](double trials) { progress.add(trials); };
  return stress::run(options.plan, *scene, stress::default_subject(), watch);
}

std::int64_t all_trials(const StressOptions& options, const std::vector<std::string>& names) {
  const auto any = std::make_shared<Scene>();
  std::int64_t sum = 0;
  for (const std::string& name : names) {
    sum += stress::planned_trials(options.plan, {name, name.empty() ? nullptr : any});
  }
  return sum;
}

Result<void> write_rows(const std::vector<stress::Row>& rows, const StressOptions& options) {
  const std::uint64_t seed = options.plan.seed;
  if (!options.json.empty()) {
    const auto written = write_output(options.json, stress::to_json(rows, seed));
    if (!written) return written;
  }
  if (options.json == "-") return {};
  return write_output("-", stress::to_text(rows, seed));
}

Result<void> run_stress(const StressOptions& options) {
  if (const auto ready = check_output(options.json); !ready) return ready;
  const std::vector<std::string> names = scene_names(options);
  const std::int64_t trials = all_trials(options, names);
  if (trials == 0) return Error{"none of the checks asked for runs there"};
  std::vector<stress::Row> rows;
  {
    Progress progress("trials", static_cast<double>(trials), Progress::mode(options.quiet));
    for (const std::string& name : names) {
      auto more = run_on(name, options, progress);
      if (!more) return more.error();
      rows.insert(rows.end(), more->begin(), more->end());
    }
  }
  if (const auto written = write_rows(rows, options); !written) return written;
  std::int64_t failures = 0;
  for (const stress::Row& row : rows) failures += row.failures;
  if (failures == 0) return {};
  return Error{fmt::format("{} of {} failed", failures,
                           counted(static_cast<std::uint64_t>(trials), "trial"))};
}

/// Names that --rays and --check take.
std::vector<std::string> known(std::string_view stress::Check::*member) {
  std::vector<std::string> names;
  for (const stress::Check& check : stress::checks()) {
    const std::string name(check.*member);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](const std::string& text) {
        if (std::ranges::find(names, text) != names.end()) return std::string();
        return fmt::format("'{}' is none of {}", text, fmt::join(names, ", "));
      },
      "");
}

void add_choice(CLI::App& command, StressOptions& options) {
  const auto groups = known(&stress::Check::group), ids = known(&stress::Check::id);
  command.add_option("--rays", options.plan.groups, "Only checks of these groups")
      ->check(one_of(groups))
      ->type_name(fmt::format("{}", fmt::join(groups, "|")))
      ->delimiter(',');
  command.add_option("--check", options.plan.ids, "Only these checks, as T05")
      ->check(one_of(ids))
      ->type_name("ID")
      ->delimiter(',');
}

void add_numbers(CLI::App& command, stress::Plan& plan) {
  const auto number = CLI::Range(std::int64_t{0}, std::int64_t{1} << 40).description("");
  command
      .add_option(
          "--trials", plan.trials,
          "Trials of each check of --check; without it, of those checks that have 1,000,000 "
          "in a full run: the others make fewer in proportion, at least 1")
      ->transform(whole_number(1, std::int64_t{1} << 40))
      ->type_name("N");
  command.add_option("--seed", plan.seed, "Seed of everything random")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--trial", plan.only, "Only the trial of that number, as a failure names it")
      ->check(number)
      ->type_name("K");
  command.add_option("--threads", plan.threads, "Threads; 0: all cores")
      ->check(CLI::Range(0, 1024).description(""))
      ->type_name("N")
      ->default_str("all cores");
}

}  // namespace

void add_stress(CLI::App& app, Run& run) {
  const auto options = std::make_shared<StressOptions>();
  CLI::App* command = add_command(
      app, "stress", "Tries to make hits go wrong: random trials by the million, none may fail",
      options->quiet);
  command
      ->add_option("SCENE", options->scene,
                   "Also on this scene: a file, spd:NAME[:SIZE], or all for every standard scene")
      ->type_name("");
  add_numbers(*command, options->plan);
  add_choice(*command, *options);
  add_json(*command, options->json);
  command->callback([options, &run] { run = [options] { return run_stress(*options); }; });
}

}  // namespace bspview
