#include "core/eval/bench/measure.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "core/base/run_time.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

/// So many fit into a cache of the second level in every layout.
constexpr std::size_t rays_a_chunk = 2048;
/// Object tests a repeat of a peer that tests every object: part of a second.
constexpr std::size_t naive_tests = 40000000;
/// Two hits of one ray are the same place within these: rounding in float of distances, and of
/// coordinates of the size of the scene.
constexpr double same_distance = 1e-4, same_coordinate = 1e-6;
/// What preparing a scene is of measuring it, about.
constexpr double preparing_share = 0.3;

using Chunk = std::span<const Ray>;

/// Every n-th chunk of the rays, so that there are about `count` of them.
std::vector<Chunk> take_chunks(std::span<const Ray> rays, std::size_t count) {
  const std::size_t all = (rays.size() + rays_a_chunk - 1) / rays_a_chunk;
  count = std::clamp<std::size_t>(count, 1, std::max<std::size_t>(1, all));
  std::vector<Chunk> chunks;
  for (std::size_t i = 0; i < count && all > 0; ++i) {
    const std::size_t first = i * all / count * rays_a_chunk;
    chunks.push_back(rays.subspan(first, std::min(rays_a_chunk, rays.size() - first)));
  }
  return chunks;
}

std::size_t ray_count(std::span<const Chunk> chunks) {
  std::size_t count = 0;
  for (const Chunk& chunk : chunks) count += chunk.size();
  return count;
}

/// Seconds that the tracer takes for the rays, after a few of them untimed: others have used the
/// caches. Loading is not timed.
double trace_seconds(Tracer& tracer, BenchKind kind, std::span<const Chunk> chunks) {
  const auto trace = [&](const Chunk& chunk) {
    tracer.load(kind, chunk);
    return time_run(1, [&] { tracer.trace(); });
  };
  trace(chunks.front());
  double seconds = 0.0;
  for (const Chunk& chunk : chunks) seconds += trace(chunk);
  return seconds;
}

std::vector<RayResult> answers(Tracer& tracer, BenchKind kind, const Chunk& chunk) {
  std::vector<RayResult> results(chunk.size());
  tracer.load(kind, chunk);
  tracer.trace();
  tracer.read(results);
  return results;
}

class SceneRun {
 public:
  SceneRun(const Scene& scene, std::span<const Peer> peers, const BenchParams& params)
      : scene_(scene), peers_(peers), params_(params) {
    const Aabb box = scene_bounds(scene);
    if (!scene.objects.empty()) diagonal_ = glm::length(Vec3d(box.hi) - Vec3d(box.lo));
    times_.name = scene.name;
    times_.objects = count_objects(scene);
  }

  Result<SceneTimes> run(const Watch& watch) {
    if (const auto prepared = prepare(watch); !prepared) return prepared.error();
    for (KindTimes& kind : times_.kinds) compare(kind, watch);
    watch.advance(0.5 * preparing_share);
    for (int repeat = 0; repeat < params_.repeats; ++repeat) {
      for (KindTimes& kind : times_.kinds) time(kind, repeat, watch);
      watch.advance((1.0 - preparing_share) / params_.repeats);
    }
    if (watch.stopped()) return Error{"stopped"};
    return std::move(times_);
  }

 private:
  bool takes_part(const Peer& peer) const {
    return !is_naive(peer) || scene_.objects.size() <= most_naive_objects;
  }

  Result<void> prepare(const Watch& watch) {
    for (const Peer& peer : peers_) {
      tracers_.emplace_back();
      if (!takes_part(peer)) continue;
      const auto tree = tree_of(peer, watch.stop);
      if (!tree) return tree.error();
      tracers_.back() = peer.enter({scene_, **tree})();
    }
    watch.advance(0.4 * preparing_share);
    const World world{scene_, trees_.front().second};
    for (const BenchKind kind : params_.kinds) {
      batches_[kind] = record_bench_rays(world, kind, params_.rays, params_.seed).rays;
      if (!batches_[kind].empty()) times_.kinds.push_back({kind, batches_[kind].size(), {}});
    }
    watch.advance(0.1 * preparing_share);
    return {};
  }

  Result<const Tree*> tree_of(const Peer& peer, std::stop_token stop) {
    const BuildParams build = peer.build.value_or(params_.build);
    for (const auto& [costs, tree] : trees_) {
      if (costs == peer.test_costs && tree.params == build) return &tree;
    }
    Result<Tree> tree = build_scene_tree(scene_, build, stop, peer.test_costs);
    if (!tree) return tree.error();
    return &trees_.emplace_back(peer.test_costs, *std::move(tree)).second;
  }

  std::vector<Chunk> chunks_for(const Peer& peer, BenchKind kind) const {
    const std::size_t tests = scene_.objects.size() * rays_a_chunk;
    const std::size_t count =
        is_naive(peer) ? naive_tests / std::max<std::size_t>(1, tests) : no_index;
    return take_chunks(batches_.at(kind), count);
  }

  /// Whether both found the same, the one `t` away being the default's answer.
  void count(const RayResult& found, const RayResult& expected, BenchKind kind,
             PeerTimes& times) const {
    const bool hit = found.object != no_index, expected_hit = expected.object != no_index;
    if (hit != expected_hit) {
      ++(expected_hit ? times.lost : times.phantom);
    } else if (hit && kind != BenchKind::shadow) {
      const double allowed = std::max(same_distance * expected.t, same_coordinate * diagonal_);
      times.elsewhere += !(std::abs(found.t - expected.t) <= allowed);
    }
  }

  void compare(KindTimes& kind, const Watch& watch) {
    kind.peers.resize(peers_.size());
    for (std::size_t i = 0; i < peers_.size(); ++i) {
      if (!tracers_[i]) continue;
      const std::vector<Chunk> chunks = chunks_for(peers_[i], kind.kind);
      kind.peers[i].rays = ray_count(chunks);
      for (const Chunk& chunk : chunks) {
        if (watch.stopped() || i == 0) break;
        const auto expected = answers(*tracers_.front(), kind.kind, chunk);
        const auto found = answers(*tracers_[i], kind.kind, chunk);
        for (std::size_t k = 0; k < chunk.size(); ++k) {
          count(found[k], expected[k], kind.kind, kind.peers[i]);
        }
      }
    }
  }

  /// Each repeat begins with another peer: the first one finds the caches worse.
  void time(KindTimes& kind, int repeat, const Watch& watch) {
    for (std::size_t turn = 0; turn < peers_.size(); ++turn) {
      const std::size_t i = (turn + static_cast<std::size_t>(repeat)) % peers_.size();
      if (!tracers_[i] || watch.stopped()) continue;
      PeerTimes& times = kind.peers[i];
      const double seconds =
          trace_seconds(*tracers_[i], kind.kind, chunks_for(peers_[i], kind.kind));
      times.nanoseconds.push_back(1e9 * seconds / static_cast<double>(times.rays));
    }
  }

  const Scene& scene_;
  const std::span<const Peer> peers_;
  const BenchParams& params_;
  double diagonal_ = 0.0;
  std::deque<std::pair<TestCosts, Tree>> trees_;  // of the first peer, then others
  std::vector<std::unique_ptr<Tracer>> tracers_;  // by peer; null: takes no part
  std::map<BenchKind, std::vector<Ray>> batches_;
  SceneTimes times_;
};

}  // namespace

Result<SceneTimes> measure_scene(const Scene& scene, std::span<const Peer> peers,
                                 const BenchParams& params, const Watch& watch) {
  return SceneRun(scene, peers, params).run(watch);
}

}  // namespace bspview
