#include "app/viewer/run_window.h"

#include <algorithm>
#include <atomic>
#include <ctime>

#include "app/viewer/exported_state.h"
#include "app/viewer/session.h"
#include "app/viewer/window.h"
#include "core/base/timer.h"

namespace bspview {
namespace {

constexpr int frames_after_event = 3;        // Dear ImGui's answer to an event takes two
constexpr int frames_of_tooltip = 2;         // it measures itself in the first, unseen
constexpr double shortest_frame = 1.0 / 60;  // seconds; not every display waits for its refresh
constexpr double minimised_nap = 0.1;        // seconds

std::string screenshot_name() {
  const std::time_t now = std::time(nullptr);
  char text[64];
  std::strftime(text, sizeof text, "bspview-%Y%m%d-%H%M%S.png", std::localtime(&now));
  return text;
}

/// The loop around the frames: draws when there is something new, sleeps otherwise.
class Loop {
 public:
  Loop(const ViewerOptions& options, Window& window, Session& session, std::atomic<bool>& news)
      : window_(window),
        session_(session),
        news_(news),
        ui_map_(options.ui_map),
        state_file_(options.state) {}

  Result<void> run() {
    while (!window_.close_wanted() && !session_.app().take_quit()) {
      window_.wait(nap());
      if (window_.take_event()) frames_due_ = frames_after_event;
      if (news_.exchange(false)) frames_due_ = std::max(frames_due_, 1);
      take_drops();
      const std::optional<double> due = session_.app().next_frame_in();
      if (!session_.input().empty()) frames_due_ = std::max(frames_due_, 1);
      if (due && *due <= 0.0) frames_due_ = std::max(frames_due_, frames_of_tooltip);
      if (frames_due_ == 0 || since_frame_.seconds() < shortest_frame) continue;
      if (const Result<void> drawn = draw(); !drawn) return drawn;
    }
    return {};
  }

 private:
  std::optional<double> nap() const {
    if (window_.size().empty()) return minimised_nap;
    const bool wanted = frames_due_ > 0 || news_ || !session_.input().empty();
    if (wanted) return std::max(0.0, shortest_frame - since_frame_.seconds());
    return session_.app().next_frame_in();
  }

  Result<void> draw() {
    const WindowSize size = window_.size();
    if (size.empty()) return {};
    const float seconds = static_cast<float>(since_frame_.seconds());
    since_frame_.restart();
    session_.frame(size, seconds);
    if (frames_due_ > 0) --frames_due_;
    serve_wishes(size);
    show_title();
    window_.show_cursor(ImGui::GetMouseCursor());
    window_.swap();
    return export_files();
  }

  void serve_wishes(const WindowSize& size) {
    App& app = session_.app();
    if (app.take_full_screen()) window_.toggle_full_screen();
    if (!app.take_screenshot()) return;
    const std::string name = screenshot_name();
    const Result<void> saved = save_screenshot(size, name);
    app.state().notice =
        saved ? "Saved " + std::filesystem::absolute(name).string() : saved.error().message;
    frames_due_ = frames_after_event;
  }

  void show_title() {
    const auto& scene = session_.app().results().scene;
    const std::string title = scene ? scene->scene.name + " – bspview" : "bspview";
    if (title != title_) window_.set_title(title);
    title_ = title;
  }

  void take_drops() {
    for (const std::string& file : window_.take_dropped_files()) session_.app().open(file);
  }

  Result<void> export_files() {
    if (ui_map_.wanted())
      if (const auto done = ui_map_.update(export_widgets(session_.app().widgets())); !done)
        return done;
    if (state_file_.wanted()) return state_file_.update(export_state(session_.app()));
    return {};
  }

  Window& window_;
  Session& session_;
  std::atomic<bool>& news_;
  ExportedFile ui_map_, state_file_;
  std::string title_;
  Timer since_frame_;
  int frames_due_ = frames_after_event;
};

}  // namespace

Result<void> run_window(const ViewerOptions& options, State state, Settings& settings) {
  const int width = options.width > 0 ? options.width : settings.window_width;
  const int height = options.height > 0 ? options.height : settings.window_height;
  const Result<std::unique_ptr<Window>> window = Window::create(width, height);
  if (!window) return window.error();
  std::atomic<bool> news = false;
  const auto session = Session::create(std::move(state), [&news] {
    news = true;
    Window::wake_up();
  });
  if (!session) return session.error();
  (*window)->connect((*session)->input());
  (*window)->share_clipboard();
  const Result<void> result = Loop(options, **window, **session, news).run();
  const WindowSize size = (*window)->size();
  settings = settings_of((*session)->app().state(), size.empty() ? width : size.width,
                         size.empty() ? height : size.height);
  return result;
}

}  // namespace bspview
