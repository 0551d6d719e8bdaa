#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <utility>

namespace bspview::gl {

enum class ObjectKind { texture, vertex_array, framebuffer, renderbuffer, shader, program };
void delete_object(ObjectKind kind, GLuint name);

/// Owns one OpenGL object. The name 0 is none.
template <ObjectKind kind>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Handle() {
    if (name_ != 0) delete_object(kind, name_);
  }

  GLuint get() const { return name_; }

 private:
  GLuint name_ = 0;
};

using TextureHandle = Handle<ObjectKind::texture>;
using VertexArrayHandle = Handle<ObjectKind::vertex_array>;
using FramebufferHandle = Handle<ObjectKind::framebuffer>;
using RenderbufferHandle = Handle<ObjectKind::renderbuffer>;
using ShaderHandle = Handle<ObjectKind::shader>;
using ProgramHandle = Handle<ObjectKind::program>;

}  // namespace bspview::gl
