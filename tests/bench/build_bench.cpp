// Seconds to build the tree of each standard scene with each builder, median and spread of nine
// repetitions, with what the time depends on: time and references an object, and the expected cost
// of the tree.

#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include "core/bsp/stats.h"
#include "core/eval/lambda.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

void build(benchmark::State& state, const SpdScene& spd, Builder builder) {
  const auto scene = make_spd(spd.name);
  if (!scene) return state.SkipWithError(scene.error().message.c_str());
  const SceneBuildInput objects(*scene);
  const BuildInput input = objects.input();
  const BuildParams params{.builder = builder};
  TreeStats stats;
  for (auto _ : state) {
    const auto tree = build_tree(input, params);
    if (!tree) return state.SkipWithError(tree.error().message.c_str());
    state.PauseTiming();
    stats = tree_stats(*tree);
    state.ResumeTiming();
  }
  const auto count = static_cast<double>(input.boxes.size());
  state.counters["references/object"] = static_cast<double>(stats.references) / count;
  state.counters["expected_cost"] = stats.expected_cost;
  state.counters["time/object"] = benchmark::Counter(
      count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

double spread(const std::vector<double>& seconds) {
  return summarise(seconds).spread;
}

bool register_all() {
  for (const SpdScene& spd : spd_scenes()) {
    for (std::size_t i = 1; i < builder_names().size(); ++i) {
      const auto builder = static_cast<Builder>(i);
      const std::string name = fmt::format("build/{}/{}", spd.name, name_of(builder));
      benchmark::RegisterBenchmark(
          name.c_str(), [&spd, builder](benchmark::State& state) { build(state, spd, builder); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime()
          ->Repetitions(9)
          ->ComputeStatistics("spread", spread)
          ->ReportAggregatesOnly();
    }
  }
  return true;
}

const bool registered = register_all();

}  // namespace
}  // namespace bspview
