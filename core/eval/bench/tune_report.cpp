#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/counted.h"
#include "core/eval/bench/tune.h"
#include "core/eval/machine_json.h"

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, TestCosts{}.size()> kind_names{"triangles", "polygons",
                                                                      "spheres", "cones"};

std::string cost_text(ObjectKind kind, float cost) {
  return fmt::format("{} {:g}{}", kind_names[static_cast<std::size_t>(kind)], cost,
                     kind == ObjectKind::polygon ? " a corner" : "");
}

std::string name_of(const Trial& trial) {
  switch (trial.what) {
    case Trial::What::as_given:
      return "as given";
    case Trial::What::cost:
      return cost_text(trial.kind, test_cost(trial.recipe.test_costs, trial.kind));
    case Trial::What::depth:
      return fmt::format("depth {}", *trial.recipe.build.max_depth);
    case Trial::What::leaf_size:
      break;
  }
  return fmt::format("leaf size {}", trial.recipe.build.leaf_size);
}

std::string row(const TunedScene& scene, std::size_t trial) {
  const Measured faster = gain(scene, trial);
  const TreeFacts& facts = scene.trees.trees[trial];
  std::string text = fmt::format("  {:<19} {:>6.3f} {:>6.3f}", name_of(scene.trials[trial]),
                                 faster.median, faster.spread);
  for (const KindTimes& kind : scene.trees.times.kinds) {
    text += fmt::format(" {:>9.3f}", 1e3 / summarise(kind.peers[trial].nanoseconds).median);
  }
  return text + fmt::format(" {:>8.2f} {:>8.2f} {:>8.3f} {:>8.1f}\n", facts.nodes_a_ray,
                            facts.tests_a_hit, facts.build_seconds,
                            1e-6 * static_cast<double>(facts.bytes));
}

std::string table(const TunedScene& scene) {
  std::string text = fmt::format(
      "\n{}, {}; depth {}, C_I {:.2f}\n  {:<19} {:>6} {:>6}", scene.trees.times.name,
      counted(scene.trees.times.objects.objects, "object"), scene.trees.trees[0].max_depth,
      scene.trees.trees[0].cost_intersection, "", "gain", "+-");
  for (const KindTimes& kind : scene.trees.times.kinds) {
    text += fmt::format(" {:>9}", name_of(kind.kind));
  }
  text += fmt::format(" {:>8} {:>8} {:>8} {:>8}\n", "N_AT", "N_RPRT", "T_CB", "MB");
  for (std::size_t i = 0; i < scene.trials.size(); ++i) text += row(scene, i);
  return text;
}

std::string summary(const TuneReport& report) {
  std::string text =
      fmt::format("\n{:<24} best, and its gain over what was given, measured anew\n", "");
  double most = 1.0;
  for (const TunedScene& scene : report.scenes) {
    const Measured faster = scene.best_gain;
    most = std::max(most, faster.median);
    text += fmt::format("  {:<22} {:<19} {:.3f} +- {:.3f}\n", scene.trees.times.name,
                        name_of(scene.trials[best_trial(scene)]), faster.median, faster.spread);
  }
  text += "\nC_I that suits each kind of object, C_T being " +
          fmt::format("{:g}:", report.params.bench.build.cost_traversal);
  const char* before = " ";
  for (std::size_t i = 0; i < kind_names.size(); ++i) {
    const auto kind = static_cast<ObjectKind>(i);
    const auto cost = fitted_cost(report, kind);
    if (cost) text += std::exchange(before, ", ") + cost_text(kind, *cost);
  }
  return text +
         fmt::format("\nWhat was given is at most {:.1f} % slower than the best of each sweep.\n",
                     100.0 * (most - 1.0));
}

Json trial_json(const TunedScene& scene, std::size_t trial) {
  const BuildParams& build = scene.trials[trial].recipe.build;
  const TreeFacts& facts = scene.trees.trees[trial];
  const Measured faster = gain(scene, trial);
  Json json{{"name", name_of(scene.trials[trial])},
            {"cost_intersection", facts.cost_intersection},
            {"max_depth", facts.max_depth},
            {"leaf_size", build.leaf_size},
            {"gain", faster.median},
            {"gain_spread", faster.spread},
            {"N_AT", facts.nodes_a_ray},
            {"N_RPRT", facts.tests_a_hit},
            {"T_CB", facts.build_seconds},
            {"bytes", facts.bytes},
            {"expected_cost", facts.expected_cost}};
  for (const KindTimes& kind : scene.trees.times.kinds) {
    json["ns"][std::string(name_of(kind.kind))] = kind.peers[trial].nanoseconds;
  }
  return json;
}

}  // namespace

std::string to_text(const TuneReport& report) {
  std::string text = fmt::format(
      "about {} rays of every kind a scene, recorded once; {}, one thread\n"
      "gain: time through the tree that was given over that through this one, geometric mean over "
      "the kinds of rays, median\n      of the repeats +- half the distance of the quartiles; "
      "Mrays/s by kind; T_CB in seconds\n",
      report.params.bench.rays, counted(report.params.bench.repeats, "interleaved repeat"));
  for (const TunedScene& scene : report.scenes) text += table(scene);
  return text + summary(report);
}

std::string to_json(const TuneReport& report) {
  Json json{{"rays", report.params.bench.rays}, {"repeats", report.params.bench.repeats}};
  for (std::size_t i = 0; i < kind_names.size(); ++i) {
    const auto cost = fitted_cost(report, static_cast<ObjectKind>(i));
    json["cost_intersection"][std::string(kind_names[i])] = cost ? Json(*cost) : Json(nullptr);
  }
  for (const TunedScene& scene : report.scenes) {
    Json trials = Json::array();
    for (std::size_t i = 0; i < scene.trials.size(); ++i) trials.push_back(trial_json(scene, i));
    json["scenes"].push_back({{"name", scene.trees.times.name},
                              {"objects", scene.trees.times.objects.objects},
                              {"best", name_of(scene.trials[best_trial(scene)])},
                              {"best_gain", scene.best_gain.median},
                              {"best_gain_spread", scene.best_gain.spread},
                              {"trials", std::move(trials)}});
  }
  json["machine"] = machine_json(report.machine);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bspview
