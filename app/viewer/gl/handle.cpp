#include "app/viewer/gl/handle.h"

namespace bspview::gl {

void delete_object(ObjectKind kind, GLuint name) {
  switch (kind) {
    case ObjectKind::texture:
      return glDeleteTextures(1, &name);
    case ObjectKind::vertex_array:
      return glDeleteVertexArrays(1, &name);
    case ObjectKind::framebuffer:
      return glDeleteFramebuffers(1, &name);
    case ObjectKind::renderbuffer:
      return glDeleteRenderbuffers(1, &name);
    case ObjectKind::shader:
      return glDeleteShader(name);
    case ObjectKind::program:
      return glDeleteProgram(name);
  }
}

}  // namespace bspview::gl
