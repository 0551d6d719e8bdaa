// Milliseconds from a newer wish to the end of the work for a tree that nobody wants any more, at
// moments spread evenly over that work: the median, and the longest of all.

#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/viewer/work.h"
#include "core/base/check.h"
#include "core/base/timer.h"
#include "core/eval/lambda.h"

namespace bspview {
namespace {

std::shared_ptr<const LoadedScene> open(const std::string& source) {
  std::shared_ptr<const LoadedScene> scene;
  const auto publish = [&](auto loaded) { scene = loaded; };
  BSPVIEW_CHECK(open_scene({source}, {}, publish).ok());
  return scene;
}

/// Other planes for every i: each is built anew.
TreeRequest request_of(const std::shared_ptr<const LoadedScene>& scene, int i) {
  return {scene, {.empty_bonus = 0.1f + 1e-4f * static_cast<float>(i)}};
}

/// Seconds until it is stopped, after `wait` seconds.
double drop(TreeWork& work, const TreeRequest& request, double wait) {
  std::stop_source stop;
  std::future<void> done = std::async(
      std::launch::async, [&] { (void)work(request, stop.get_token(), [](const auto&) {}); });
  std::this_thread::sleep_for(std::chrono::duration<double>(wait));
  const Timer timer;
  stop.request_stop();
  done.wait();
  return timer.seconds();
}

void drop_tree(benchmark::State& state, const std::string& source) {
  const auto scene = open(source);
  TreeWork work;
  BSPVIEW_CHECK(work({scene, {}}, {}, [](const auto&) {}).ok());
  double whole = 0.0;
  const Timer timer;
  const auto note = [&](const auto&) { whole = timer.seconds(); };
  BSPVIEW_CHECK(work(request_of(scene, 1), {}, note).ok());
  std::vector<double> seconds;
  for (auto _ : state) {
    const auto i = static_cast<double>(seconds.size());
    const double share = (i + 0.5) / static_cast<double>(state.max_iterations);
    seconds.push_back(
        drop(work, request_of(scene, 2 + static_cast<int>(seconds.size())), share * whole));
    state.SetIterationTime(seconds.back());
  }
  state.counters["objects"] = static_cast<double>(scene->counts.objects);
  state.counters["whole_ms"] = 1e3 * whole;
  state.counters["median_ms"] = 1e3 * summarise(seconds).median;
  state.counters["longest_ms"] = 1e3 * *std::ranges::max_element(seconds);
}

bool register_all() {
  for (const char* source : {"spd:gears:9", "spd:mount:9", "spd:tetra:10", "spd:gears:19"}) {
    benchmark::RegisterBenchmark(fmt::format("drop/{}", source).c_str(),
                                 [source](benchmark::State& state) { drop_tree(state, source); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(60);
  }
  return true;
}

const bool registered = register_all();

}  // namespace
}  // namespace bspview
