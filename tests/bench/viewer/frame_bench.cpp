#include <benchmark/benchmark.h>

#include <chrono>
#include <thread>

#include "app/viewer/offscreen.h"
#include "app/viewer/session.h"
#include "core/base/check.h"

namespace bspview {
namespace {

constexpr WindowSize size{1280, 800, 1280, 800, 1.0f};
constexpr float frame_seconds = 1.0f / 60;

/// The whole viewer, off-screen, with every leaf box of a tree of over 20,000 leaves.
struct Viewer {
  Viewer() {
    auto made = Offscreen::create(size);
    BSPVIEW_CHECK(made.ok());
    offscreen = *std::move(made);
    State state;
    open_source(state, "spd:gears");
    state.boxes.visible = true;
    state.boxes.cells = BoxView::Cells::all;
    state.measure_times = false;
    state.picture.samples = 1;
    auto started = Session::create(state, [] {});
    BSPVIEW_CHECK(started.ok());
    session = *std::move(started);
  }

  void settle() {
    do {
      session->frame(size, frame_seconds);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (session->app().busy() || session->app().next_frame_in());
  }

  std::unique_ptr<Offscreen> offscreen;
  std::unique_ptr<Session> session;
};

/// One frame of the interface when nothing changes.
void frame_at_rest(benchmark::State& state) {
  Viewer viewer;
  viewer.settle();
  for (auto _ : state) {
    viewer.session->frame(size, frame_seconds);
    glFinish();
  }
  state.counters["leaves"] =
      static_cast<double>(viewer.session->app().results().tree->stats.leaves);
}
BENCHMARK(frame_at_rest)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One frame of the interface while the camera turns; pictures and overlays are made beside it.
void frame_while_turning(benchmark::State& state) {
  Viewer viewer;
  viewer.settle();
  std::size_t pictures = 0, overlays = 0;
  const Picture* picture = nullptr;
  const Overlay* overlay = nullptr;
  for (auto _ : state) {
    State& wishes = viewer.session->app().state();
    wishes.view.camera->orbit({3.0f, 0.5f}, wishes.view.size);
    viewer.session->frame(size, frame_seconds);
    glFinish();
    const Results& results = viewer.session->app().results();
    pictures += std::exchange(picture, results.picture.get()) != picture ? 1 : 0;
    overlays += std::exchange(overlay, results.overlay.get()) != overlay ? 1 : 0;
  }
  using benchmark::Counter;
  state.counters["pictures"] = Counter(static_cast<double>(pictures), Counter::kIsRate);
  state.counters["overlays"] = Counter(static_cast<double>(overlays), Counter::kIsRate);
}
BENCHMARK(frame_while_turning)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(3.0);

}  // namespace
}  // namespace bspview
