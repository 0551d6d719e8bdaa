#include "app/viewer/gl/texture.h"

#include "core/base/check.h"

namespace bspview::gl {

void Texture::write(std::span<const std::uint32_t> pixels, int width, int height) {
  BSPVIEW_CHECK(pixels.size() == static_cast<std::size_t>(width) * height);
  if (width != width_ || height != height_) allocate(width, height);
  bind();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  // The whole picture at once: pixel buffer objects are slower on software renderers.
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

void Texture::bind() const {
  glBindTexture(GL_TEXTURE_2D, handle_.get());
}

void Texture::allocate(int width, int height) {
  if (handle_.get() == 0) {
    GLuint name = 0;
    glGenTextures(1, &name);
    handle_ = TextureHandle(name);
  }
  width_ = width;
  height_ = height;
  bind();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

}  // namespace bspview::gl
