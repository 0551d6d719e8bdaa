#include "core/eval/bench/build_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

constexpr std::array<std::string_view, 4> families{"mount", "tetra", "balls", "gears"};
constexpr double farthest_size = 3.0;  // from the wanted one, a factor

std::vector<Builder> sah_builders() {
  std::vector<Builder> builders;
  for (std::size_t i = 0; i < builder_names().size(); ++i) {
    if (builder_names()[i].starts_with("sah")) builders.push_back(static_cast<Builder>(i));
  }
  return builders;
}

double total_objects(const BuildBenchParams& params) {
  double total = 0.0;
  for (const std::string_view name : families) {
    for (const int size : nearest_sizes(name, params.sizes)) {
      total += *count_spd_objects(name, size);
    }
  }
  return total;
}

class BuildRun {
 public:
  BuildRun(const BuildBenchParams& params, const Watch& watch)
      : watch_(watch), total_objects_(total_objects(params)) {
    report_.params = params;
    if (report_.params.builders.empty()) report_.params.builders = sah_builders();
    report_.peers = own_builders(params.build, report_.params.builders);
    for (BuildPeer& peer : embree_builders()) report_.peers.push_back(std::move(peer));
    report_.threads = thread_steps(params.build.threads);
  }

  Result<BuildReport> run() {
    for (const std::string_view name : families) {
      BuildFamily& family = report_.families.emplace_back();
      family.name = name;
      for (const int size : nearest_sizes(name, report_.params.sizes)) {
        const Result<Scene> scene = make_spd(name, size);
        if (!scene) return scene.error();
        auto built = measure(*scene);
        if (!built) return Error{scene->name + ": " + built.error().message};
        family.sizes.push_back(*std::move(built));
      }
    }
    for (const Scene& scene : report_.params.scenes) {
      auto compared = compare(scene);
      if (!compared) return Error{scene.name + ": " + compared.error().message};
      report_.quality.push_back(*std::move(compared));
    }
    return std::move(report_);
  }

 private:
  Result<TreeComparison> compare(const Scene& scene) const {
    std::vector<TreeRecipe> recipes;
    for (const Builder builder : report_.params.builders) {
      recipes.emplace_back().build = report_.params.build;
      recipes.back().build.builder = builder;
    }
    const BenchParams bench{.rays = report_.params.rays, .repeats = report_.params.repeats};
    return compare_trees(scene, recipes, bench, Watch(watch_.stop));
  }

  Result<BuiltScene> measure(const Scene& scene) {
    BuiltScene built{scene.name, scene.objects.size(), {}};
    for (std::size_t peer = 0; peer < report_.peers.size(); ++peer) {
      for (const int threads : report_.threads)
        built.times.push_back({.peer = peer, .threads = threads});
    }
    const Timer timer;
    for (int repeat = 0; repeat < report_.params.repeats; ++repeat) {
      if (repeat > 0 && timer.seconds() > report_.params.patience) break;
      for (BuildTimes& times : built.times) {
        if (const auto done = build_once(scene, times); !done) return done.error();
        if (repeat == 0) advance(built);
      }
    }
    return built;
  }

  Result<void> build_once(const Scene& scene, BuildTimes& times) const {
    auto build = report_.peers[times.peer].build(scene, times.threads, watch_.stop);
    if (!build) return build.error();
    if (watch_.stopped()) return Error{"stopped"};
    times.seconds.push_back(build->seconds);
    times.bytes = build->bytes;
    times.shape = build->shape;
    return {};
  }

  void advance(const BuiltScene& built) const {
    const auto objects = static_cast<double>(built.objects);
    watch_.advance(objects / (total_objects_ * static_cast<double>(built.times.size())));
  }

  const Watch& watch_;
  const double total_objects_;
  BuildReport report_;
};

}  // namespace

std::vector<int> nearest_sizes(std::string_view name, std::span<const double> objects) {
  std::map<double, int> counts;  // of objects, and the size that makes them
  const double most = farthest_size * std::ranges::max(objects);
  for (int size = 1;; ++size) {
    const Result<double> count = count_spd_objects(name, size);
    if (!count || *count > std::min(most, max_spd_objects)) break;
    counts.emplace(*count, size);
  }
  std::vector<int> sizes;
  for (const double wanted : objects) {
    const auto off = [&](const auto& entry) { return std::abs(std::log(entry.first / wanted)); };
    const auto nearest = std::ranges::min_element(counts, {}, off);
    if (nearest != counts.end() && off(*nearest) <= std::log(farthest_size)) {
      sizes.push_back(nearest->second);
    }
  }
  std::ranges::sort(sizes);
  sizes.erase(std::ranges::unique(sizes).begin(), sizes.end());
  return sizes;
}

const BuildTimes* find_times(const BuiltScene& scene, std::size_t peer, int threads) {
  const auto found = std::ranges::find_if(scene.times, [&](const BuildTimes& times) {
    return times.peer == peer && times.threads == threads && !times.seconds.empty();
  });
  return found == scene.times.end() ? nullptr : &*found;
}

std::optional<PowerFit> fit_of(const BuildFamily& family, std::size_t peer, int threads) {
  std::vector<std::pair<double, double>> points;
  for (const BuiltScene& scene : family.sizes) {
    const BuildTimes* const times = find_times(scene, peer, threads);
    if (!times) continue;
    const auto n = static_cast<double>(scene.objects);
    points.emplace_back(n * std::log2(n), std::log2(summarise(times->seconds).median));
  }
  if (points.size() < 3) return {};
  const LogFit fit = fit_log(points);
  return PowerFit{fit.a_doubling, fit.r2};
}

Result<BuildReport> run_build_bench(const BuildBenchParams& params, const Watch& watch) {
  return BuildRun(params, watch).run();
}

}  // namespace bspview
