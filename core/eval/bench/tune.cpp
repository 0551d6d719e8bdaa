#include "core/eval/bench/tune.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bspview {
namespace {

std::vector<ObjectKind> kinds_in(const Scene& scene) {
  std::vector<ObjectKind> kinds;
  for (std::size_t i = 0; i < TestCosts{}.size(); ++i) {
    const auto kind = static_cast<ObjectKind>(i);
    if (std::ranges::find(scene.objects, kind, &Object::kind) != scene.objects.end()) {
      kinds.push_back(kind);
    }
  }
  return kinds;
}

std::vector<Trial> trials_of(const Scene& scene, const TuneParams& params) {
  const TreeRecipe given{.build = params.bench.build};
  std::vector<Trial> trials{{Trial::What::as_given, given}};
  for (const ObjectKind kind : kinds_in(scene)) {
    for (const float cost : params.costs) {
      Trial& trial = trials.emplace_back(Trial{Trial::What::cost, given, kind});
      trial.recipe.test_costs[static_cast<std::size_t>(kind)] = cost;
    }
  }
  const int depth = effective_depth(given.build, scene.objects.size());
  for (const int more : params.depths) {
    Trial& trial = trials.emplace_back(Trial{Trial::What::depth, given});
    trial.recipe.build.max_depth = std::clamp(depth + more, 1, depth_cap);
  }
  for (const int size : params.leaf_sizes) {
    trials.emplace_back(Trial{Trial::What::leaf_size, given}).recipe.build.leaf_size = size;
  }
  return trials;
}

Watch watch_share(const Watch& watch, double share) {
  Watch part(watch.stop);
  part.progress = [&watch, share](double more) { watch.advance(more * share); };
  return part;
}

Result<Measured> measure_anew(const Scene& scene, std::span<const TreeRecipe, 2> recipes,
                              BenchParams params, const Watch& watch) {
  constexpr int more_repeats = 3;
  params.repeats *= more_repeats;
  const auto trees = compare_trees(scene, recipes, params, watch);
  if (!trees) return trees.error();
  return time_ratio(trees->times, 0, 1);
}

Result<TunedScene> tune(const Scene& scene, const TuneParams& params, const Watch& watch) {
  constexpr double sweep_share = 0.8;
  TunedScene tuned{.trials = trials_of(scene, params)};
  std::vector<TreeRecipe> recipes;
  for (const Trial& trial : tuned.trials) recipes.push_back(trial.recipe);
  auto trees = compare_trees(scene, recipes, params.bench, watch_share(watch, sweep_share));
  if (!trees) return trees.error();
  tuned.trees = *std::move(trees);
  const std::array both{recipes[0], recipes[best_trial(tuned)]};
  const auto anew = measure_anew(scene, both, params.bench, watch_share(watch, 1.0 - sweep_share));
  if (!anew) return anew.error();
  tuned.best_gain = *anew;
  return tuned;
}

}  // namespace

Result<TuneReport> run_tune(std::span<const Scene> scenes, const TuneParams& params,
                            const Watch& watch) {
  TuneReport report{.params = params};
  for (const Scene& scene : scenes) {
    const double share = 1.0 / static_cast<double>(scenes.size());
    auto tuned = tune(scene, params, watch_share(watch, share));
    if (!tuned) return tuned.error();
    report.scenes.push_back(*std::move(tuned));
  }
  return report;
}

Measured gain(const TunedScene& scene, std::size_t trial) {
  return time_ratio(scene.trees.times, 0, trial);
}

std::size_t best_trial(const TunedScene& scene) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < scene.trials.size(); ++i) {
    if (gain(scene, i).median > gain(scene, best).median) best = i;
  }
  return best;
}

std::optional<float> fitted_cost(const TuneReport& report, ObjectKind kind) {
  constexpr double as_good = 0.01;
  std::map<float, double> log_gain;  // of a cost, added up over the scenes
  double scenes = 0.0;
  for (const TunedScene& scene : report.scenes) {
    bool is_there = false;
    for (std::size_t i = 0; i < scene.trials.size(); ++i) {
      const Trial& trial = scene.trials[i];
      if (trial.what != Trial::What::cost || trial.kind != kind) continue;
      log_gain[test_cost(trial.recipe.test_costs, kind)] += std::log(gain(scene, i).median);
      is_there = true;
    }
    scenes += is_there ? 1.0 : 0.0;
  }
  if (log_gain.empty()) return {};
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& [cost, sum] : log_gain) most = std::max(most, sum);
  const auto is_enough = [&](const auto& entry) { return entry.second >= most - scenes * as_good; };
  return std::ranges::find_if(log_gain, is_enough)->first;
}

}  // namespace bspview
