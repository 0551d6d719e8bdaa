// Steps of the walk through wide nodes, without object tests: of one ray, of a packet, and what
// getting a ray ready for it takes. The nodes fit the second level of the cache; time/node is that
// of a step with its share of getting ready.

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/render/hits.h"
#include "tests/bench/recorded_world.h"

namespace bspview {
namespace {

/// Whether a ray passes a cell of a node before `end`; never that of a slot without one.
bool passes(const WideNode& node, int slot, const Ray& ray, float end) {
  float first = ray.t_min, last = end;
  for (int axis = 0; axis < 3; ++axis) {
    const int near = 2 * axis + static_cast<int>(std::signbit(ray.direction[axis]));
    const auto distance = [&](int row) {
      return (node.bounds[row][slot] - ray.origin[axis]) / ray.direction[axis];
    };
    first = std::max(first, distance(near));
    last = std::min(last, distance(near ^ 1));
  }
  return first <= last;
}

/// The nodes that a ray comes to before `end`: a step each.
std::size_t count_nodes(const WideTree& tree, const Ray& ray, float end) {
  std::size_t count = 0;
  for (std::vector<std::uint32_t> open{0}; !open.empty(); ++count) {
    const WideNode& node = tree.nodes[open.back()];
    open.pop_back();
    for (int slot = 0; slot < WideNode::width; ++slot) {
      const std::uint32_t child = node.child[slot];
      if (!(child & WideNode::leaf_bit) && passes(node, slot, ray, end)) open.push_back(child);
    }
  }
  return count;
}

/// Rays, and how far each of them walks.
struct Walks {
  test::RecordedWorld recorded;
  std::vector<float> ends;            // t of the hit, or t_max
  std::vector<std::uint32_t> leaves;  // visited up to there
  std::size_t nodes = 0;              // of all rays

  explicit Walks(BenchKind kind) : recorded("mount", 6, kind, 4096) {
    const World& world = recorded.world();
    for (const Ray& ray : recorded.rays()) {
      const Hit hit = fast_closest_hit(world, ray, SideRule::two_sided);
      ends.push_back(hit ? static_cast<float>(hit.t) : ray.t_max);
      leaves.push_back(count_leaves(world, ray, {}, false));
      nodes += count_nodes(world.accelerator->tree(), ray, ends.back());
    }
  }
};

void report(benchmark::State& state, const Walks& walks) {
  using benchmark::Counter;
  const auto rays = static_cast<double>(walks.ends.size());
  const auto nodes = static_cast<double>(walks.nodes);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(walks.ends.size()));
  state.counters["nodes/ray"] = nodes / rays;
  state.counters["tree_bytes"] =
      static_cast<double>(walks.recorded.world().accelerator->tree().bytes());
  state.counters["time/node"] =
      Counter(nodes, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void walk_one_ray(benchmark::State& state) {
  const Walks walks(BenchKind::scattered);
  const World& world = walks.recorded.world();
  const std::vector<Ray>& rays = walks.recorded.rays();
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (walks.leaves[i] == 0) continue;
      benchmark::DoNotOptimize(walk_leaves(world, rays[i], walks.leaves[i]));
    }
  }
  report(state, walks);
}
BENCHMARK(walk_one_ray)->Unit(benchmark::kMicrosecond);

void ready_one_ray(benchmark::State& state) {
  const test::RecordedWorld recorded("mount", 6, BenchKind::scattered, 4096);
  for (auto _ : state) {
    for (const Ray& ray : recorded.rays()) {
      benchmark::DoNotOptimize(walk_leaves(recorded.world(), ray, 0));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(recorded.rays().size()));
}
BENCHMARK(ready_one_ray)->Unit(benchmark::kMicrosecond);

void walk_packet(benchmark::State& state) {
  const Walks walks(BenchKind::primary);
  const World& world = walks.recorded.world();
  std::vector<Ray> rays = walks.recorded.rays();
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i].t_max = walks.ends[i];
  for (auto _ : state) {
    benchmark::DoNotOptimize(walk_together(world, rays, true));
  }
  report(state, walks);
  state.SetLabel(packet_instructions());
}
BENCHMARK(walk_packet)->Unit(benchmark::kMicrosecond);

void ready_packet(benchmark::State& state) {
  const test::RecordedWorld recorded("mount", 6, BenchKind::primary, 4096);
  for (auto _ : state) {
    benchmark::DoNotOptimize(walk_together(recorded.world(), recorded.rays(), false));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(recorded.rays().size()));
}
BENCHMARK(ready_packet)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bspview
