#include "core/eval/bench/trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/bsp/stats.h"
#include "core/render/accelerator.h"
#include "core/render/hits.h"

namespace bspview {
namespace {

/// Traces as pictures do.
class PictureTracer : public Tracer {
 public:
  explicit PictureTracer(const FastWorld& fast) : fast_(fast) {}

  void load(BenchKind kind, std::span<const Ray> rays) override {
    kind_ = kind;
    rays_.assign(rays.begin(), rays.end());
    hits_.resize(rays.size());
    objects_.resize(rays.size());
  }

  void trace() override {
    const World& world = fast_.world();
    switch (kind_) {
      case BenchKind::primary:
        return closest_hits(world, rays_, SideRule::two_sided, hits_);
      case BenchKind::shadow:
        return any_hits(world, rays_, SideRule::two_sided, objects_);
      case BenchKind::scattered:
        for (std::size_t i = 0; i < rays_.size(); ++i) {
          hits_[i] = fast_closest_hit(world, rays_[i], SideRule::two_sided);
        }
    }
  }

  void read(std::span<RayResult> results) const override {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const RayResult found{objects_[i] != no_index ? 0 : no_index, 0.0};
      results[i] = kind_ == BenchKind::shadow ? found : RayResult{hits_[i].object, hits_[i].t};
    }
  }

 private:
  const FastWorld fast_;
  BenchKind kind_ = BenchKind::primary;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
  std::vector<std::uint32_t> objects_;
};

/// What rays cost in a tree, by the walk that Delta counts.
void count_rays(const World& world, std::span<const BenchBatch> batches, TreeFacts& facts) {
  RayCost cost;
  CountObserver counter(cost);
  std::size_t rays = 0, hits = 0;
  for (const BenchBatch& batch : batches) {
    const bool any = batch.kind == BenchKind::shadow;
    for (const Ray& ray : batch.rays) {
      hits += any ? any_hit(world, ray, {}, counter) != no_index
                  : static_cast<bool>(closest_hit(world, ray, {}, counter));
    }
    rays += batch.rays.size();
  }
  const auto ratio = [](std::uint64_t a, std::size_t b) {
    return b == 0 ? 0.0 : static_cast<double>(a) / static_cast<double>(b);
  };
  facts.nodes_a_ray = ratio(cost.inner + cost.leaves, rays);
  facts.tests_a_hit = ratio(cost.tests, hits);
}

TreeFacts facts_of(const World& world, std::span<const BenchBatch> batches) {
  TreeFacts facts{world.tree.build_seconds, world.tree.bytes(), world.tree.max_depth,
                  world.tree.cost_intersection, tree_stats(world.tree).expected_cost};
  count_rays(world, batches, facts);
  return facts;
}

/// The trees of one scene as peers of the benchmark of speed, each of which leaves its facts.
class TreePeers {
 public:
  TreePeers(std::span<const TreeRecipe> recipes, const BenchParams& params)
      : params_(params), facts_(recipes.size()) {
    for (std::size_t i = 0; i < recipes.size(); ++i) {
      Peer& peer = peers_.emplace_back();
      peer.name = fmt::format("tree {}", i);
      peer.build = recipes[i].build;
      peer.test_costs = recipes[i].test_costs;
      peer.enter = [this, i](const World& world) { return enter(world, i); };
    }
  }

  std::span<const Peer> peers() const { return peers_; }
  std::vector<TreeFacts> take_facts() { return std::move(facts_); }

 private:
  MakeTracer enter(const World& world, std::size_t i) {
    if (batches_.empty()) {
      for (const BenchKind kind : params_.kinds) {
        batches_.push_back(record_bench_rays(world, kind, params_.rays, params_.seed));
      }
    }
    facts_[i] = facts_of(world, batches_);
    return [fast = FastWorld(world)] { return std::make_unique<PictureTracer>(fast); };
  }

  const BenchParams& params_;
  std::vector<Peer> peers_;
  std::vector<TreeFacts> facts_;
  std::vector<BenchBatch> batches_;
};

}  // namespace

Result<TreeComparison> compare_trees(const Scene& scene, std::span<const TreeRecipe> recipes,
                                     const BenchParams& params, const Watch& watch) {
  TreePeers trees(recipes, params);
  Result<SceneTimes> times = measure_scene(scene, trees.peers(), params, watch);
  if (!times) return times.error();
  if (times->kinds.empty()) return Error{scene.name + ": its view has no such rays"};
  for (const KindTimes& kind : times->kinds) {
    for (const PeerTimes& peer : kind.peers) {
      if (peer.wrong() > 0) return Error{scene.name + ": trees have different hits"};
    }
  }
  return TreeComparison{*std::move(times), trees.take_facts()};
}

Measured time_ratio(const SceneTimes& times, std::size_t tree, std::size_t base) {
  std::vector<double> ratios(times.kinds.front().peers[tree].nanoseconds.size());
  for (std::size_t repeat = 0; repeat < ratios.size(); ++repeat) {
    double log_ratio = 0.0;
    for (const KindTimes& kind : times.kinds) {
      log_ratio +=
          std::log(kind.peers[tree].nanoseconds[repeat] / kind.peers[base].nanoseconds[repeat]);
    }
    ratios[repeat] = std::exp(log_ratio / static_cast<double>(times.kinds.size()));
  }
  return summarise(std::move(ratios));
}

}  // namespace bspview
