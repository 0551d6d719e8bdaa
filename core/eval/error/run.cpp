#include "core/eval/error/run.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>

#include "core/eval/error/embree_kernel.h"
#include "core/eval/error/offset.h"
#include "core/eval/error/time.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

constexpr int pilot_repeats = 3;
// What a stage is of the whole, about.
constexpr double judging_share = 0.4, timing_share = 0.6;

/// One scene, ready to be measured.
struct Stand {
  explicit Stand(const Scene& one) : scene(one), reference(one) {}

  const Scene& scene;
  Reference reference;
  std::map<Builder, Tree> trees;
  std::vector<RayBatch> batches;
  std::vector<BoundKernel> kernels;  // by configuration
  SceneErrors errors;
};

class ErrorRun {
 public:
  ErrorRun(const ErrorParams& params, const Watch& watch)
      : params_(params), watch_(watch), design_(params.traversal, params.build.builder) {
    report_.params = params;
  }

  Result<void> add(const Scene& scene) {
    Stand& stand = stands_.emplace_back(scene);
    for (int i = 0; i < design_.level_count(Factor::tree); ++i) {
      BuildParams build = params_.build;
      build.builder = design_.builder(i);
      Result<Tree> tree = build_scene_tree(scene, build, watch_.stop);
      if (!tree) return tree.error();
      stand.trees.emplace(build.builder, *std::move(tree));
    }
    const RecordParams record{params_.rays, params_.build.threads, params_.seed};
    auto batches = record_batches(world_of(stand, params_.build.builder), record, watch_);
    if (!batches) return batches.error();
    stand.batches = *std::move(batches);
    SceneErrors& errors = stand.errors;
    errors.name = scene.name;
    errors.objects = count_objects(scene);
    errors.only_triangles = has_only_triangles(scene);
    for (const RayBatch& batch : stand.batches) {
      errors.rays[static_cast<std::size_t>(batch.group)] = batch.rays.size();
    }
    return {};
  }

  Result<ErrorReport> run() {
    const std::vector<Levels> single = design_.one_at_a_time();
    judge(single, 0.4);
    time(pilot_repeats);
    report_.strongest_factors = strongest(single);
    std::vector<Levels> all = single;
    add_levels(all, design_.combinations(report_.strongest_factors));
    judge(std::span(all).subspan(single.size()), 0.6);
    for (Stand& stand : stands_) stand.errors.seconds.assign(report_.configs.size(), {});
    time(params_.repeats);
    if (watch_.stopped()) return Error{"stopped"};
    for (Stand& stand : stands_) report_.scenes.push_back(std::move(stand.errors));
    return std::move(report_);
  }

 private:
  World world_of(const Stand& stand, Builder builder) const {
    return {stand.scene, stand.trees.at(builder)};
  }

  std::size_t ray_count() const {
    std::size_t sum = 0;
    for (const Stand& stand : stands_) {
      for (const RayBatch& batch : stand.batches) sum += batch.rays.size();
    }
    return sum;
  }

  ErrorConfig pictures_config() const {
    ErrorConfig config = design_.config(design_.accurate());
    config.kernel = make_fast_kernel();
    config.name = "pictures";
    config.what = "the default as pictures trace it: exact, in wide nodes";
    return config;
  }

  /// Adds configurations and judges what they answer.
  void judge(std::span<const Levels> levels, double share) {
    const std::size_t first = report_.configs.size();
    for (const Levels& one : levels) report_.configs.push_back(design_.config(one));
    if (first == 0) {
      report_.pictures_config = report_.configs.size();
      report_.configs.push_back(pictures_config());
      for (ErrorConfig& foreign : embree_configs()) report_.configs.push_back(std::move(foreign));
    }
    const double a_ray =
        judging_share * share / static_cast<double>(std::max<std::size_t>(1, ray_count()));
    Watch counted(watch_.stop);
    counted.progress = [&](double rays) { watch_.advance(rays * a_ray); };
    for (Stand& stand : stands_) judge_scene(stand, first, counted);
  }

  void judge_scene(Stand& stand, std::size_t first, const Watch& watch) {
    const JudgedScene judged{world_of(stand, params_.build.builder), stand.reference, stand.batches,
                             params_.build.threads};
    for (std::size_t i = first; i < report_.configs.size(); ++i) {
      const ErrorConfig& config = report_.configs[i];
      const bool fits = config.choice || stand.errors.only_triangles;
      stand.errors.measured.push_back(fits);
      stand.kernels.push_back(fits ? BoundKernel(config, world_of(stand, config.builder))
                                   : BoundKernel());
    }
    const auto added = std::span(std::as_const(stand.kernels)).subspan(first);
    std::vector<ErrorCounts> counts = judge_hits(judged, added, watch);
    const std::vector<OffsetCounts> offsets = judge_offsets(judged, added, params_.seed);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      counts[i].offset = offsets[i];
      stand.errors.counts.push_back(counts[i]);
    }
    stand.errors.seconds.resize(report_.configs.size());
  }

  /// Interleaved: all configurations, then all again.
  void time(int repeats) {
    const double a_run =
        timing_share / (static_cast<double>(stands_.size()) * (pilot_repeats + params_.repeats));
    for (Stand& stand : stands_) {
      for (int repeat = 0; repeat < repeats; ++repeat) {
        for (const RayBatch& batch : stand.batches) {
          if (!is_aimed(batch.group)) time_batch(stand, batch);
        }
        watch_.advance(a_run);
      }
    }
  }

  void time_batch(Stand& stand, const RayBatch& batch) {
    for (std::size_t i = 0; i < report_.configs.size(); ++i) {
      if (watch_.stopped() || !stand.errors.measured[i]) continue;
      stand.errors.seconds[i][static_cast<std::size_t>(batch.group)].push_back(
          time_rays(stand.kernels[i], batch, params_.timing_threads));
    }
  }

  /// Nanoseconds of an average ray, and the rate of wrong answers of every sort, over all scenes.
  struct Effect {
    double time = 0.0, error = 0.0;
  };
  Effect effect_of(std::size_t config) const {
    double seconds = 0.0, cases = 0.0, wrong = 0.0;
    for (const Stand& stand : stands_) {
      for (const auto& repeats : stand.errors.seconds[config]) {
        seconds += repeats.empty() ? 0.0 : *std::ranges::min_element(repeats);
      }
      const ErrorCounts& counts = stand.errors.counts[config];
      const HitCounts ordinary = counts.ordinary(), aimed = counts.aimed();
      cases += static_cast<double>(ordinary.rays + aimed.rays + counts.offset.leaving +
                                   counts.offset.hidden);
      wrong += static_cast<double>(ordinary.wrong() + aimed.wrong() + counts.offset.acne +
                                   counts.offset.leaks);
    }
    return {seconds, std::max(wrong, 3.0) / std::max(cases, 1.0)};
  }

  /// How far a factor alone moves an anchor, in powers of e of time and error together.
  std::vector<Factor> strongest(std::span<const Levels> single) const {
    std::array<double, factor_count> strength{};
    for (std::size_t i = 0; i < single.size(); ++i) {
      for (const std::size_t anchor : {fast_config, default_config}) {
        const auto factor = only_difference(single[i], single[anchor]);
        if (!factor) continue;
        const Effect one = effect_of(i), other = effect_of(anchor);
        double& most = strength[static_cast<std::size_t>(*factor)];
        most = std::max(most, std::abs(std::log(one.time / other.time)) +
                                  std::abs(std::log(one.error / other.error)));
      }
    }
    std::vector<Factor> factors(factor_count);
    for (std::size_t i = 0; i < factor_count; ++i) factors[i] = static_cast<Factor>(i);
    std::ranges::stable_sort(factors, [&](Factor a, Factor b) {
      return strength[static_cast<std::size_t>(a)] > strength[static_cast<std::size_t>(b)];
    });
    factors.resize(3);
    return factors;
  }

  const ErrorParams params_;
  const Watch& watch_;
  ErrorDesign design_;
  std::deque<Stand> stands_;  // kernels point into them
  ErrorReport report_;
};

}  // namespace

Result<ErrorReport> measure_errors(std::span<const Scene> scenes, const ErrorParams& params,
                                   const Watch& watch) {
  ErrorRun run(params, watch);
  for (const Scene& scene : scenes) {
    if (const auto added = run.add(scene); !added) return added.error();
  }
  return run.run();
}

}  // namespace bspview
