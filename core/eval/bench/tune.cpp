#include "core/eval/bench/tune.h"

#include <algorithm>
#include <cmath>

namespace bspview {
namespace {

std::vector<Trial> trials_of(const Scene& scene, const TuneParams& params) {
  const BuildParams& given = params.bench.build;
  std::vector<Trial> trials{{Trial::What::as_given, given}};
  const auto add = [&](Trial::What what) -> BuildParams& {
    return trials.emplace_back(Trial{what, given}).build;
  };
  for (const float cost : params.costs) add(Trial::What::cost).cost_intersection = cost;
  const int depth = effective_depth(given, scene.objects.size());
  for (const int more : params.depths) {
    add(Trial::What::depth).max_depth = std::clamp(depth + more, 1, depth_cap);
  }
  for (const int size : params.leaf_sizes) add(Trial::What::leaf_size).leaf_size = size;
  return trials;
}

}  // namespace

Result<TuneReport> run_tune(std::span<const Scene> scenes, const TuneParams& params,
                            const Watch& watch) {
  TuneReport report{.params = params};
  Watch part(watch.stop);
  part.progress = [&](double more) { watch.advance(more / static_cast<double>(scenes.size())); };
  for (const Scene& scene : scenes) {
    const std::vector<Trial> trials = trials_of(scene, params);
    std::vector<BuildParams> builds;
    for (const Trial& trial : trials) builds.push_back(trial.build);
    auto trees = compare_trees(scene, builds, params.bench, part);
    if (!trees) return trees.error();
    report.scenes.push_back(
        {surface_shares(scene, object_bounds(scene)), trials, *std::move(trees)});
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

std::optional<double> fitted_cost(const TuneReport& report, ObjectKind kind) {
  constexpr double as_good = 0.01;
  const std::vector<float>& costs = report.params.costs;
  std::vector<double> log_time(costs.size(), 0.0);
  double weights = 0.0;
  for (const TunedScene& scene : report.scenes) {
    const double weight = scene.shares[static_cast<std::size_t>(kind)];
    weights += weight;
    auto time = log_time.begin();
    for (std::size_t i = 0; i < scene.trials.size(); ++i) {
      if (scene.trials[i].what != Trial::What::cost) continue;
      *time++ -= weight * std::log(gain(scene, i).median);
    }
  }
  if (weights == 0.0) return {};
  const double enough = std::ranges::min(log_time) + weights * as_good;
  const auto first = std::ranges::find_if(log_time, [&](double time) { return time <= enough; });
  return costs[static_cast<std::size_t>(first - log_time.begin())];
}

}  // namespace bspview
