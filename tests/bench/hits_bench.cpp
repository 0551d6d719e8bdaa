// The whole loops: packets of eye and shadow rays through spd:teapot, as they come in tiles of
// 8 x 8 pixels, and one ray at a time of those that are scattered and shuffled in spd:mount. Wide
// nodes and leaves of both fit the second or third level of the cache.

#include <benchmark/benchmark.h>

#include "core/render/hits.h"
#include "tests/bench/recorded_world.h"

namespace bspview {
namespace {

constexpr std::size_t ray_count = 16'384;

struct Rays {
  const char* spd;
  BenchKind kind;
};

void report(benchmark::State& state, const test::RecordedWorld& recorded) {
  const std::size_t rays = recorded.rays().size();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays));
}

void trace_packets(benchmark::State& state, Rays which) {
  const test::RecordedWorld recorded(which.spd, {}, which.kind, ray_count);
  std::vector<Hit> hits(recorded.rays().size());
  for (auto _ : state) {
    closest_hits(recorded.world(), recorded.rays(), SideRule::two_sided, hits);
    benchmark::DoNotOptimize(hits.data());
    benchmark::ClobberMemory();
  }
  report(state, recorded);
  state.SetLabel(packet_instructions());
}
BENCHMARK_CAPTURE(trace_packets, teapot_primary, Rays{"teapot", BenchKind::primary})
    ->Unit(benchmark::kMillisecond);

void trace_shadow_packets(benchmark::State& state, Rays which) {
  const test::RecordedWorld recorded(which.spd, {}, which.kind, ray_count);
  std::vector<std::uint32_t> blockers(recorded.rays().size());
  for (auto _ : state) {
    any_hits(recorded.world(), recorded.rays(), SideRule::two_sided, blockers);
    benchmark::DoNotOptimize(blockers.data());
    benchmark::ClobberMemory();
  }
  report(state, recorded);
  state.SetLabel(packet_instructions());
}
BENCHMARK_CAPTURE(trace_shadow_packets, teapot_shadow, Rays{"teapot", BenchKind::shadow})
    ->Unit(benchmark::kMillisecond);

void trace_one_by_one(benchmark::State& state, Rays which) {
  const test::RecordedWorld recorded(which.spd, {}, which.kind, ray_count);
  for (auto _ : state) {
    for (const Ray& ray : recorded.rays()) {
      benchmark::DoNotOptimize(fast_closest_hit(recorded.world(), ray, SideRule::two_sided));
    }
  }
  report(state, recorded);
}
BENCHMARK_CAPTURE(trace_one_by_one, mount_scattered, Rays{"mount", BenchKind::scattered})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace_one_by_one, teapot_primary, Rays{"teapot", BenchKind::primary})
    ->Unit(benchmark::kMillisecond);

void trace_shadow_one_by_one(benchmark::State& state, Rays which) {
  const test::RecordedWorld recorded(which.spd, {}, which.kind, ray_count);
  for (auto _ : state) {
    for (const Ray& ray : recorded.rays()) {
      benchmark::DoNotOptimize(fast_any_hit(recorded.world(), ray, SideRule::two_sided));
    }
  }
  report(state, recorded);
}
BENCHMARK_CAPTURE(trace_shadow_one_by_one, teapot_shadow, Rays{"teapot", BenchKind::shadow})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bspview
