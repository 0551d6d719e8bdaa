#pragma once

#include <cstdint>
#include <span>

#include "app/viewer/gl/handle.h"

namespace bspview::gl {

/// RGBA8 texture that pictures of changing size are written to.
class Texture {
 public:
  /// `pixels`: width x height, top row first, red in the lowest byte.
  void write(std::span<const std::uint32_t> pixels, int width, int height);
  bool empty() const { return width_ == 0; }
  /// For the texture unit that is active.
  void bind() const;

 private:
  void allocate(int width, int height);

  TextureHandle handle_;
  int width_ = 0, height_ = 0;
};

}  // namespace bspview::gl
