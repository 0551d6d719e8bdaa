#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/viewer/app.h"
#include "app/viewer/gl/screen.h"
#include "app/viewer/interface.h"
#include "core/base/result.h"

namespace bspview {

/// One run of the viewer on whatever OpenGL context is current: interface, app and screen.
class Session {
 public:
  static Result<std::unique_ptr<Session>> create(State state, std::function<void()> wake);

  /// Draws one frame of `size`, `seconds` after the one before.
  void frame(const WindowSize& size, float seconds);

  App& app() { return app_; }
  const App& app() const { return app_; }
  InputQueue& input() { return interface_->input(); }

 private:
  Session(State state, std::function<void()> wake, std::unique_ptr<Interface> interface,
          std::unique_ptr<gl::Screen> screen);

  std::unique_ptr<Interface> interface_;
  std::unique_ptr<gl::Screen> screen_;
  App app_;
};

/// Saves what is in the bound framebuffer as PNG.
Result<void> save_screenshot(const WindowSize& size, const std::filesystem::path& file);

}  // namespace bspview
