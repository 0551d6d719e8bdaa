#include "app/viewer/gl/image_renderer.h"

#include "app/viewer/gl/shader.h"
#include "app/viewer/gl/shader_text.h"

namespace bspview::gl {

Result<ImageRenderer> ImageRenderer::create() {
  Result<ProgramHandle> program =
      build_program(shader_text::viewport_vert, shader_text::picture_frag);
  if (!program) return program.error();
  GLuint vertices = 0;
  glGenVertexArrays(1, &vertices);
  return ImageRenderer(std::move(*program), VertexArrayHandle(vertices));
}

void ImageRenderer::draw(const Texture& texture, const PixelRect& rect, Blend blend) const {
  if (texture.empty() || rect.width <= 0 || rect.height <= 0) return;
  glViewport(rect.x, rect.y, rect.width, rect.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  if (blend == Blend::over) {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  } else {
    glDisable(GL_BLEND);
  }
  glActiveTexture(GL_TEXTURE0);
  texture.bind();
  glUseProgram(program_.get());
  glBindVertexArray(vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace bspview::gl
