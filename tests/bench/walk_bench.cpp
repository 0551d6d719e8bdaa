// Steps of the walk through wide nodes, without object tests: of one ray, of a packet, and what
// getting a ray ready for it takes. The nodes fit the second level of the cache; time/node is that
// of a step with its share of getting ready.

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/render/hits.h"
#include "tests/bench/recorded_world.h"

namespace bspview {
namespace {

/// Whether a ray passes a cell of a node; never that of a slot without one.
bool passes(const WideNode& node, int slot, const Ray& ray) {
  float first = ray.t_min, last = ray.t_max;
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

/// The nodes that a ray comes to: a step each.
std::size_t count_nodes(const WideTree& tree, const Ray& ray) {
  std::size_t count = 0;
  for (std::vector<std::uint32_t> open{0}; !open.empty(); ++count) {
    const WideNode& node = tree.nodes[open.back()];
    open.pop_back();
    for (int slot = 0; slot < WideNode::width; ++slot) {
      const std::uint32_t child = node.child[slot];
      if (!(child & WideNode::leaf_bit) && passes(node, slot, ray)) open.push_back(child);
    }
  }
  return count;
}

/// Rays, and how far each of them walks.
struct Walks {
  test::RecordedWorld recorded;
  std::vector<Ray> rays;  // up to what they hit
  std::size_t nodes = 0;  // of all rays

  explicit Walks(BenchKind kind) : recorded("mount", 6, kind, 4096) {
    const World& world = recorded.world();
    for (const Ray& recorded_ray : recorded.rays()) {
      Ray& ray = rays.emplace_back(recorded_ray);
      const Hit hit = fast_closest_hit(world, ray, SideRule::two_sided);
      if (hit) ray.t_max = static_cast<float>(hit.t);
      nodes += count_nodes(world.accelerator->tree(), ray);
    }
  }
};

void report(benchmark::State& state, const Walks& walks) {
  using benchmark::Counter;
  const auto rays = static_cast<double>(walks.rays.size());
  const auto nodes = static_cast<double>(walks.nodes);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(walks.rays.size()));
  state.counters["nodes/ray"] = nodes / rays;
  state.counters["tree_bytes"] =
      static_cast<double>(walks.recorded.world().accelerator->tree().bytes());
  state.counters["time/node"] =
      Counter(nodes, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void walk_one_ray(benchmark::State& state) {
  const Walks walks(BenchKind::scattered);
  const World& world = walks.recorded.world();
  for (auto _ : state) {
    for (const Ray& ray : walks.rays) benchmark::DoNotOptimize(walk_alone(world, ray, true));
  }
  report(state, walks);
}
BENCHMARK(walk_one_ray)->Unit(benchmark::kMicrosecond);

void ready_one_ray(benchmark::State& state) {
  const test::RecordedWorld recorded("mount", 6, BenchKind::scattered, 4096);
  for (auto _ : state) {
    for (const Ray& ray : recorded.rays()) {
      benchmark::DoNotOptimize(walk_alone(recorded.world(), ray, false));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(recorded.rays().size()));
}
BENCHMARK(ready_one_ray)->Unit(benchmark::kMicrosecond);

void walk_packet(benchmark::State& state) {
  const Walks walks(BenchKind::primary);
  for (auto _ : state) {
    benchmark::DoNotOptimize(walk_together(walks.recorded.world(), walks.rays, true));
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
