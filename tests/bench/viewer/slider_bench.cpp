// Seconds from the move of a slider of the tree to what it changes on the screen: the tree with its
// half of Delta, the boxes in the picture, and the half of Delta that needs every ray. The
// interface runs without OpenGL, at a small size of the window. And how many trees and boxes a
// second there are while the hand does not rest.

#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/base/check.h"
#include "core/base/timer.h"
#include "core/eval/lambda.h"
#include "tests/gui/app_rig.h"

namespace bspview {
namespace {

State boxes_of(const std::string& source) {
  State state;
  open_source(state, source);
  state.boxes.visible = true;
  state.measure_times = false;
  state.picture.samples = 1;
  return state;
}

/// The i-th position of a slider: near the one before, over and over the same range.
using Slider = void (*)(BuildParams& params, int i);

void depth(BuildParams& params, int i) {
  params.max_depth = 12 + i % 30;
}
void leaf_size(BuildParams& params, int i) {
  params.leaf_size = 1 + i % 30;
}
void cost_of_nodes(BuildParams& params, int i) {
  params.cost_traversal = 0.5f + 0.05f * static_cast<float>(i % 30);
}

/// Seconds. A large tree of `sah` may be sketched first: `exact` is that of the tree itself.
struct Moves {
  std::vector<double> tree, boxes, rays, exact;
  std::size_t count = 0;
};

void add_move(AppRig& rig, Moves& moves) {
  const BuildParams& wish = rig.state().build;
  const auto is_it = [&](const std::shared_ptr<const BuiltTree>& tree) {
    if (!tree) return false;
    BuildParams params = tree->request.params;
    params.builder = wish.builder;
    return params == wish;
  };
  const auto rays = [&](const Results& results) {
    return is_it(results.tree) && results.now->delta.n_at.has_value();
  };
  const auto boxes = [&](const Results& results) {
    return results.overlay && is_it(results.overlay->request.tree);
  };
  const auto exact = [&](const Results& results) { return results.tree->request.params == wish; };
  const Timer timer;
  const auto note = [&](std::vector<double>& seconds, bool is_there) {
    if (is_there && seconds.size() == moves.count) seconds.push_back(timer.seconds());
    return seconds.size() > moves.count;
  };
  BSPVIEW_CHECK(rig.wait_for([&] {
    const Results& now = rig.results();
    const bool all[] = {note(moves.tree, is_it(now.tree)), note(moves.boxes, boxes(now)),
                        note(moves.rays, rays(now)), note(moves.exact, exact(now))};
    return std::ranges::count(all, false) == 0;
  }));
  ++moves.count;
}

struct NamedSlider {
  const char* name;
  Slider slide;
};

void move_slider(benchmark::State& state, const std::string& source, Slider slider) {
  AppRig rig(boxes_of(source));
  BSPVIEW_CHECK(rig.settle());
  const auto objects = static_cast<double>(rig.results().scene->counts.objects);
  Moves first, moves;
  slider(rig.app().state().build, 31);  // the first move beyond the tree builds a larger one
  add_move(rig, first);
  BSPVIEW_CHECK(rig.settle());
  int i = 0;
  for (auto _ : state) {
    slider(rig.app().state().build, i++);
    add_move(rig, moves);
    state.PauseTiming();
    BSPVIEW_CHECK(rig.settle());
    state.ResumeTiming();
  }
  const auto milliseconds = [](const std::vector<double>& seconds) {
    return 1e3 * summarise(seconds).median;
  };
  state.counters["objects"] = objects;
  state.counters["first_ms"] = milliseconds(first.boxes);
  state.counters["tree_ms"] = milliseconds(moves.tree);
  state.counters["boxes_ms"] = milliseconds(moves.boxes);
  state.counters["rays_ms"] = milliseconds(moves.rays);
  state.counters["exact_ms"] = milliseconds(moves.exact);
}

void drag_slider(benchmark::State& state, const std::string& source, Slider slider) {
  constexpr auto frame = std::chrono::milliseconds(16);
  AppRig rig(boxes_of(source));
  BSPVIEW_CHECK(rig.settle());
  slider(rig.app().state().build, 31);
  BSPVIEW_CHECK(rig.settle());
  std::size_t trees = 0, boxes = 0;
  const BuiltTree *tree = nullptr, *drawn = nullptr;
  int i = 0;
  for (auto _ : state) {
    slider(rig.app().state().build, i++);
    rig.frame();
    const Results& results = rig.results();
    trees += std::exchange(tree, results.tree.get()) != tree ? 1 : 0;
    const BuiltTree* const of = results.overlay ? results.overlay->request.tree.get() : nullptr;
    boxes += std::exchange(drawn, of) != drawn ? 1 : 0;
    std::this_thread::sleep_for(frame);
  }
  using benchmark::Counter;
  state.counters["trees"] = Counter(static_cast<double>(trees), Counter::kIsRate);
  state.counters["boxes"] = Counter(static_cast<double>(boxes), Counter::kIsRate);
}

bool register_all() {
  for (const char* source : {"spd:mount:6", "spd:gears:4", "spd:mount:8", "spd:gears:9",
                             "spd:tetra:10", "spd:gears:19"}) {
    for (const auto& [name, slider] :
         {NamedSlider{"depth", depth}, {"leaf_size", leaf_size}, {"cost", cost_of_nodes}}) {
      benchmark::RegisterBenchmark(fmt::format("slider/{}/{}", source, name).c_str(),
                                   [source, slider = slider](benchmark::State& state) {
                                     move_slider(state, source, slider);
                                   })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime()
          ->Iterations(20);
      benchmark::RegisterBenchmark(fmt::format("drag/{}/{}", source, name).c_str(),
                                   [source, slider = slider](benchmark::State& state) {
                                     drag_slider(state, source, slider);
                                   })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime()
          ->Iterations(200);
    }
  }
  return true;
}

const bool registered = register_all();

}  // namespace
}  // namespace bspview
