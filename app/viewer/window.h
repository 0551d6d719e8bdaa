#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/input_queue.h"
#include "app/viewer/window_size.h"
#include "core/base/result.h"

struct GLFWwindow;
struct GLFWcursor;

namespace bspview {

/// The window on the user's display, with an OpenGL 3.3 context that is current on the thread that
/// made it. One at a time.
class Window {
 public:
  /// `width` x `height` in the units of the cursor. The error is one clear sentence: no display, no
  /// OpenGL 3.3.
  static Result<std::unique_ptr<Window>> create(int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// What the user did arrives here.
  void connect(InputQueue& input) { input_ = &input; }

  WindowSize size() const;
  bool close_wanted() const;
  void set_title(const std::string& title);
  void toggle_full_screen();
  /// ImGui's cursor of this frame.
  void show_cursor(ImGuiMouseCursor cursor);
  /// For Dear ImGui's text fields of the current context.
  void share_clipboard();
  void swap();

  /// Sleeps until there is an event (or wake_up), at most `longest` seconds where given.
  void wait(std::optional<double> longest);
  /// True once after any event.
  bool take_event() { return std::exchange(event_, false); }
  std::vector<std::string> take_dropped_files() { return std::exchange(dropped_, {}); }

  /// Ends wait(); from any thread.
  static void wake_up();

 private:
  Window() = default;
  void set_callbacks();
  void push(const InputEvent& event);
  static Window& of(GLFWwindow* window);

  GLFWwindow* window_ = nullptr;
  InputQueue* input_ = nullptr;
  bool event_ = false;
  std::vector<std::string> dropped_;
  GLFWcursor* cursors_[ImGuiMouseCursor_COUNT] = {};
  int windowed_[4] = {};  // x, y, width, height before full screen
};

}  // namespace bspview
