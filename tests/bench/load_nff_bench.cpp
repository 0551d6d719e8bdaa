#include <benchmark/benchmark.h>

#include "core/scene/load.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

void parse_polygons(benchmark::State& state) {
  const std::string text = format_nff(*make_spd("sombrero", static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(parse_nff(text, "sombrero.nff"));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(parse_polygons)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

void format_polygons(benchmark::State& state) {
  const Result<Scene> scene = make_spd("sombrero");
  std::size_t bytes = 0;
  for (auto _ : state) bytes += format_nff(*scene).size();
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}
BENCHMARK(format_polygons)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bspview
