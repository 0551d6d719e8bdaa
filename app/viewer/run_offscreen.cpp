#include "app/viewer/run_offscreen.h"

#include <fmt/format.h>

#include <utility>

#include "app/viewer/bell.h"
#include "app/viewer/exported_state.h"
#include "app/viewer/offscreen.h"
#include "app/viewer/script.h"
#include "app/viewer/session.h"
#include "core/base/file.h"

namespace bspview {
namespace {

constexpr float frame_seconds = 1.0f / 60.0f;  // of the virtual clock
constexpr int frames_to_settle = 3;
constexpr std::chrono::milliseconds longest_nap{20};

WindowSize window_size(const ViewerOptions& options) {
  WindowSize size;
  if (options.width > 0) size.width = size.pixel_width = options.width;
  if (options.height > 0) size.height = size.pixel_height = options.height;
  return size;
}

/// The viewer on an off-screen buffer.
class Stand {
 public:
  static Result<std::unique_ptr<Stand>> create(const ViewerOptions& options, State state) {
    std::unique_ptr<Stand> stand(new Stand);
    stand->size_ = window_size(options);
    Result<std::unique_ptr<Offscreen>> offscreen = Offscreen::create(stand->size_);
    if (!offscreen) return offscreen.error();
    stand->offscreen_ = *std::move(offscreen);
    auto session = Session::create(std::move(state), stand->bell_.ringer());
    if (!session) return session.error();
    stand->session_ = *std::move(session);
    return stand;
  }

  App& app() { return session_->app(); }
  InputQueue& input() { return session_->input(); }
  void frame() { session_->frame(size_, frame_seconds); }

  /// Draws until nothing is left to compute, and a little more to show the last of it.
  void settle() {
    for (int idle = 0; idle < frames_to_settle;) {
      frame();
      const bool resting = !app().busy() && !app().next_frame_in() && input().empty();
      idle = resting ? idle + 1 : 0;
      if (!resting) bell_.wait(longest_nap);
    }
  }

  /// Draws until all input was seen and answered.
  void act() {
    while (!input().empty()) frame();
    for (int i = 0; i < frames_to_settle; ++i) frame();
  }

  Result<void> screenshot(const std::string& file) const { return save_screenshot(size_, file); }

 private:
  Stand() = default;

  WindowSize size_;
  Bell bell_;
  std::unique_ptr<Offscreen> offscreen_;
  std::unique_ptr<Session> session_;
};

Result<void> point(Stand& stand, const ScriptStep& step) {
  const Result<Vec2> place = find_place(step, stand.app().widgets());
  if (!place) return place.error();
  stand.input().push(InputEvent::move(*place));
  stand.act();
  return {};
}

Result<void> press_keys(Stand& stand, const ScriptStep& step) {
  const Result<std::vector<InputEvent>> events = chord_events(step);
  if (!events) return events.error();
  for (const InputEvent& event : *events) stand.input().push(event);
  stand.act();
  return {};
}

void button(Stand& stand, const ScriptStep& step, bool down) {
  stand.input().push(InputEvent::button(step.text == "right" ? 1 : 0, down));
  stand.act();
}

Result<void> perform(Stand& stand, const ScriptStep& step) {
  using Kind = ScriptStep::Kind;
  switch (step.kind) {
    case Kind::wait:
      stand.settle();
      return {};
    case Kind::move:
      return point(stand, step);
    case Kind::press:
      button(stand, step, true);
      return {};
    case Kind::release:
      button(stand, step, false);
      return {};
    case Kind::click: {
      const Result<void> there = point(stand, step);
      if (!there) return there;
      for (const bool down : {true, false}) stand.input().push(InputEvent::button(0, down));
      stand.act();
      return {};
    }
    case Kind::wheel:
      stand.input().push(InputEvent::wheel({0.0f, std::strtof(step.text.c_str(), nullptr)}));
      stand.act();
      return {};
    case Kind::key:
      return press_keys(stand, step);
    case Kind::type:
      for (const char character : step.text) stand.input().push(InputEvent::text(character));
      stand.act();
      return {};
    case Kind::drop:
      stand.app().open(step.text);
      return {};
    case Kind::screenshot:
      return stand.screenshot(step.text);
    case Kind::state:
      return write_file(step.text, export_state(stand.app()));
  }
  return {};
}

Result<void> check_pick(const ViewerOptions& options, const App& app) {
  const PictureSize size = app.state().view.size;
  if (!options.pick || (options.pick->column < size.width && options.pick->row < size.height))
    return {};
  return Error{fmt::format("--pick {},{} is outside the picture of {}x{} pixels",
                           options.pick->column, options.pick->row, size.width, size.height)};
}

Result<void> export_files(const ViewerOptions& options, const App& app) {
  if (!options.ui_map.empty())
    if (const auto done = write_file(options.ui_map, export_widgets(app.widgets())); !done)
      return done;
  return options.state.empty() ? Result<void>() : write_file(options.state, export_state(app));
}

}  // namespace

Result<void> run_screenshot(const ViewerOptions& options, State state) {
  if (const Result<void> writable = check_writable(options.screenshot); !writable) return writable;
  const auto stand = Stand::create(options, std::move(state));
  if (!stand) return stand.error();
  (*stand)->settle();
  const Results& results = (*stand)->app().results();
  if (results.scene_error) return *results.scene_error;
  if (results.tree_error) return *results.tree_error;
  if (const Result<void> inside = check_pick(options, (*stand)->app()); !inside) return inside;
  if (const Result<void> saved = (*stand)->screenshot(options.screenshot); !saved) return saved;
  return export_files(options, (*stand)->app());
}

Result<void> run_script(const ViewerOptions& options, State state) {
  const Result<std::string> text = read_file(options.script);
  if (!text) return text.error();
  const Result<std::vector<ScriptStep>> steps = parse_script(*text, options.script);
  if (!steps) return steps.error();
  const auto stand = Stand::create(options, std::move(state));
  if (!stand) return stand.error();
  for (const ScriptStep& step : *steps)
    if (const Result<void> done = perform(**stand, step); !done) return done;
  return {};
}

}  // namespace bspview
