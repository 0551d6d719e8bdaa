#pragma once

#include <memory>

#include "app/viewer/gl/handle.h"
#include "app/viewer/window_size.h"
#include "core/base/result.h"

namespace bspview {

/// OpenGL 3.3 without any display: EGL's surfaceless platform and a framebuffer object. Current on
/// the thread that made it, for as long as it lives.
class Offscreen {
 public:
  static Result<std::unique_ptr<Offscreen>> create(const WindowSize& size);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  const WindowSize& size() const { return size_; }

 private:
  Offscreen() = default;
  Result<void> connect();
  Result<void> attach_buffers();

  WindowSize size_;
  void* display_ = nullptr;  // EGLDisplay
  void* context_ = nullptr;  // EGLContext
  gl::FramebufferHandle framebuffer_;
  gl::RenderbufferHandle color_;
};

}  // namespace bspview
