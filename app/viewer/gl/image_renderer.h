#pragma once

#include "app/viewer/gl/handle.h"
#include "app/viewer/gl/texture.h"
#include "core/base/result.h"

namespace bspview::gl {

/// Rectangle of the framebuffer in pixels, from its lower left corner as OpenGL counts.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// How a picture meets what is there already.
enum class Blend { replace, over };  ///< over: the picture's alpha is premultiplied

/// Draws textures as a triangle that covers the whole rectangle.
class ImageRenderer {
 public:
  static Result<ImageRenderer> create();
  void draw(const Texture& texture, const PixelRect& rect, Blend blend) const;

 private:
  ImageRenderer(ProgramHandle program, VertexArrayHandle vertices)
      : program_(std::move(program)), vertices_(std::move(vertices)) {}

  ProgramHandle program_;
  VertexArrayHandle vertices_;  // empty, but core profiles insist on one
};

}  // namespace bspview::gl
