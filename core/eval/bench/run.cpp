#include "core/eval/bench/run.h"

#include <algorithm>

#include "core/scene/triangulate.h"

namespace bspview {
namespace {

constexpr std::size_t many_triangles = 1000000;

bool is_mostly_round(const Scene& scene) {
  return 2 * (scene.spheres.size() + scene.cones.size()) >= scene.objects.size();
}

class BenchRun {
 public:
  BenchRun(const BenchParams& params, const Watch& watch, double measurements)
      : params_(params), watch_(watch.stop) {
    watch_.progress = [&watch, measurements](double more) { watch.advance(more / measurements); };
    report_.params = params;
    report_.peers = own_peers();
    for (Peer& peer : embree_peers()) report_.peers.push_back(std::move(peer));
  }

  Result<void> add(const Scene& scene) {
    const int segments = bench_segments(scene, params_.segments);
    if (const auto done = add(triangulate(scene, segments), segments, report_.triangles); !done) {
      return done;
    }
    return is_mostly_round(scene) ? add(scene, 0, report_.shapes) : Result<void>();
  }

  BenchReport take_report() { return std::move(report_); }

 private:
  Result<void> add(const Scene& scene, int segments, std::vector<SceneTimes>& all) {
    auto times = measure_scene(scene, report_.peers, params_, watch_);
    if (!times) return times.error();
    if (times->kinds.empty()) return Error{scene.name + ": its view has no such rays"};
    times->segments = segments;
    all.push_back(*std::move(times));
    return {};
  }

  const BenchParams& params_;
  Watch watch_;
  BenchReport report_;
};

}  // namespace

int bench_segments(const Scene& scene, int segments) {
  return count_triangles(scene, segments) <= many_triangles ? segments : least_segments;
}

Result<BenchReport> run_bench(std::span<const Scene> scenes, const BenchParams& params,
                              const Watch& watch) {
  const auto round = std::ranges::count_if(scenes, is_mostly_round);
  BenchRun run(params, watch, static_cast<double>(scenes.size()) + static_cast<double>(round));
  for (const Scene& scene : scenes) {
    if (const auto added = run.add(scene); !added) return added.error();
  }
  return run.take_report();
}

}  // namespace bspview
