#include "app/viewer/offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace bspview {

Result<std::unique_ptr<Offscreen>> Offscreen::create(const WindowSize& size) {
  std::unique_ptr<Offscreen> offscreen(new Offscreen);
  offscreen->size_ = size;
  if (const Result<void> result = offscreen->connect(); !result) return result.error();
  if (const Result<void> result = offscreen->attach_buffers(); !result) return result.error();
  return offscreen;
}

Offscreen::~Offscreen() {
  if (display_ == nullptr) return;
  framebuffer_ = {};
  color_ = {};
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != nullptr) eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

Result<void> Offscreen::connect() {
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display != nullptr)
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display_ == nullptr || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) {
    display_ = nullptr;
    return Error{"this machine cannot draw without a display: EGL has no surfaceless platform"};
  }
  eglBindAPI(EGL_OPENGL_API);
  const EGLint config_wishes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                  EGL_PBUFFER_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display_, config_wishes, &config, 1, &count);
  const EGLint wishes[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  if (count > 0) context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, wishes);
  if (context_ == nullptr ||
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
    return Error{"this machine cannot draw without a display: EGL offers no OpenGL 3.3"};
  return {};
}

Result<void> Offscreen::attach_buffers() {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  color_ = gl::RenderbufferHandle(name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size_.pixel_width, size_.pixel_height);
  glGenFramebuffers(1, &name);
  framebuffer_ = gl::FramebufferHandle(name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.get());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return Error{"a picture of this size cannot be drawn off-screen"};
  return {};
}

}  // namespace bspview
