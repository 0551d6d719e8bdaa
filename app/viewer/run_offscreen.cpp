#include "app/viewer/run_offscreen.h"

#include "app/viewer/bell.h"
#include "app/viewer/offscreen.h"
#include "app/viewer/session.h"
#include "core/base/file.h"

namespace bspview {
namespace {

constexpr float frame_seconds = 1.0f / 60.0f;  // of the virtual clock
constexpr std::chrono::milliseconds longest_nap{20};

WindowSize window_size(const ViewerOptions& options) {
  WindowSize size;
  if (options.width > 0) size.width = size.pixel_width = options.width;
  if (options.height > 0) size.height = size.pixel_height = options.height;
  return size;
}

/// Draws until nothing is left to compute, and once more to show the last of it.
void settle(Session& session, const WindowSize& size, Bell& bell) {
  for (int idle_frames = 0; idle_frames < 3;) {
    session.frame(size, frame_seconds);
    const bool idle = !session.app().busy() && !session.app().next_frame_in() && session.input().empty();
    idle_frames = idle ? idle_frames + 1 : 0;
    if (!idle) bell.wait(longest_nap);
  }
}

}  // namespace

Result<void> run_screenshot(const ViewerOptions& options, State state) {
  if (const Result<void> writable = check_writable(options.screenshot); !writable) return writable;
  const WindowSize size = window_size(options);
  const auto offscreen = Offscreen::create(size);
  if (!offscreen) return offscreen.error();
  Bell bell;
  const auto session = Session::create(std::move(state), bell.ringer());
  if (!session) return session.error();
  settle(**session, size, bell);
  const Results& results = (*session)->app().results();
  if (results.scene_error) return *results.scene_error;
  if (results.tree_error) return *results.tree_error;
  return save_screenshot(size, options.screenshot);
}

}  // namespace bspview
