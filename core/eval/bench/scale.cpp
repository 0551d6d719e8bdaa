#include "core/eval/bench/scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/eval/bench/summary.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

constexpr std::array<std::string_view, 5> families{"tetra", "mount", "teapot", "balls", "rings"};
constexpr double least_objects = 500.0, least_growth = 3.0;
constexpr std::size_t rays_a_task = 512;
constexpr double thread_share = 0.2;  // of the whole, about

std::vector<Peer> scale_peers() {
  std::vector<Peer> peers = own_peers();
  for (Peer& peer : embree_peers()) peers.push_back(std::move(peer));
  std::erase_if(peers, [](const Peer& peer) {
    const bool is_alike = peer.foreign && peer.width == Peer::Width::many;
    return is_naive(peer) || is_alike || peer.answers != Peer::Answers::robust;
  });
  return peers;
}

/// The rays of one kind in pieces, each held by a tracer of its own.
class Crowd {
 public:
  Crowd(const MakeTracer& make, BenchKind kind, std::span<const Ray> rays)
      : kind_(kind), rays_(rays) {
    for (std::size_t i = 0; i < rays.size(); i += rays_a_task) tracers_.push_back(make());
  }

  double rays_a_second(int threads) {
    double seconds = 0.0;
    with_threads(threads, [&] {
      parallel_for(static_cast<int>(tracers_.size()),
                   [&](int i) { load(static_cast<std::size_t>(i)); });
      const Timer timer;
      parallel_for(static_cast<int>(tracers_.size()),
                   [&](int i) { tracers_[static_cast<std::size_t>(i)]->trace(); });
      seconds = timer.seconds();
    });
    return static_cast<double>(rays_.size()) / seconds;
  }

 private:
  void load(std::size_t i) {
    const std::size_t first = i * rays_a_task;
    tracers_[i]->load(kind_, rays_.subspan(first, std::min(rays_a_task, rays_.size() - first)));
  }

  const BenchKind kind_;
  const std::span<const Ray> rays_;
  std::vector<std::unique_ptr<Tracer>> tracers_;
};

class ScaleRun {
 public:
  ScaleRun(const ScaleParams& params, const Watch& watch) : params_(params), watch_(watch) {
    report_.params = params;
    report_.peers = scale_peers();
  }

  Result<ScaleReport> run() {
    for (const std::string_view family : families) {
      if (const auto done = add_family(family); !done) return done.error();
    }
    if (const auto done = try_threads(); !done) return done.error();
    return std::move(report_);
  }

 private:
  Result<void> add_family(std::string_view name) {
    ScaleFamily& family = report_.families.emplace_back();
    family.name = name;
    const std::vector<int> sizes = scale_sizes(name, least_objects, params_.max_objects);
    const double share = (1.0 - thread_share) / static_cast<double>(families.size());
    Watch part(watch_.stop);
    part.progress = [&](double more) {
      watch_.advance(more * share / static_cast<double>(sizes.size()));
    };
    for (const int size : sizes) {
      const Result<Scene> scene = make_spd(name, size);
      if (!scene) return scene.error();
      auto times = measure_scene(*scene, report_.peers, params_.bench, part);
      if (!times) return times.error();
      family.sizes.push_back(*std::move(times));
    }
    if (sizes.empty()) watch_.advance(share);
    return {};
  }

  Result<void> try_threads() {
    const auto sizes = scale_sizes(families.front(), 1.0, params_.thread_objects);
    const Result<Scene> scene = make_spd(families.front(), sizes.back());
    if (!scene) return scene.error();
    report_.thread_scene = scene->name;
    const Result<Tree> tree = build_scene_tree(*scene, params_.bench.build, watch_.stop);
    if (!tree) return tree.error();
    std::vector<MakeTracer> makers;
    for (const Peer& peer : report_.peers) makers.push_back(peer.enter({*scene, *tree}));
    for (const BenchKind kind : params_.bench.kinds) {
      const BenchBatch batch =
          record_bench_rays({*scene, *tree}, kind, params_.bench.rays, params_.bench.seed);
      if (!batch.rays.empty()) try_threads(makers, batch);
      watch_.advance(thread_share / static_cast<double>(params_.bench.kinds.size()));
    }
    return watch_.stopped() ? Result<void>(Error{"stopped"}) : Result<void>();
  }

  void try_threads(std::span<const MakeTracer> makers, const BenchBatch& batch) {
    std::vector<Crowd> crowds;
    for (const MakeTracer& make : makers) crowds.emplace_back(make, batch.kind, batch.rays);
    for (const int threads : thread_steps()) {
      ThreadTimes times{threads, batch.kind, {}};
      times.rays_a_second.resize(crowds.size());
      for (int repeat = 0; repeat < params_.bench.repeats && !watch_.stopped(); ++repeat) {
        for (std::size_t i = 0; i < crowds.size(); ++i) {
          times.rays_a_second[i].push_back(crowds[i].rays_a_second(threads));
        }
      }
      report_.threads.push_back(std::move(times));
    }
  }

  const ScaleParams& params_;
  const Watch& watch_;
  ScaleReport report_;
};

}  // namespace

std::vector<int> scale_sizes(std::string_view name, double least, double most) {
  std::vector<int> sizes;
  double last = 0.0;
  for (int size = 1;; ++size) {
    const Result<double> count = count_spd_objects(name, size);
    if (!count || *count > most) return sizes;
    if (*count < least || *count < least_growth * last) continue;
    sizes.push_back(size);
    last = *count;
  }
}

std::vector<int> thread_steps(int most) {
  const int all = thread_count(most);
  std::vector<int> counts;
  for (int count = 1; count < all; count *= 2) counts.push_back(count);
  counts.push_back(all);
  return counts;
}

LogFit fit_log(std::span<const std::pair<double, double>> objects_and_ns) {
  const auto count = static_cast<double>(objects_and_ns.size());
  double x = 0.0, y = 0.0;
  for (const auto& [objects, ns] : objects_and_ns) {
    x += std::log2(objects) / count;
    y += ns / count;
  }
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const auto& [objects, ns] : objects_and_ns) {
    const double dx = std::log2(objects) - x, dy = ns - y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const double slope = xx > 0.0 ? xy / xx : 0.0;
  return {y - slope * x, slope, xx * yy > 0.0 ? xy * xy / (xx * yy) : 0.0};
}

std::optional<LogFit> fit_of(const ScaleFamily& family, BenchKind kind, std::size_t peer) {
  std::vector<std::pair<double, double>> points;
  for (const SceneTimes& scene : family.sizes) {
    const KindTimes* const times = find_kind(scene, kind);
    if (!times) continue;
    points.emplace_back(static_cast<double>(scene.objects.objects),
                        summarise(times->peers[peer].nanoseconds).median);
  }
  return points.size() < 3 ? std::nullopt : std::optional(fit_log(points));
}

Result<ScaleReport> run_scale(const ScaleParams& params, const Watch& watch) {
  return ScaleRun(params, watch).run();
}

}  // namespace bspview
