#pragma once

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "app/viewer/gl/image_renderer.h"
#include "app/viewer/gl/texture.h"
#include "app/viewer/requests.h"
#include "app/viewer/results.h"
#include "app/viewer/window_size.h"

namespace bspview::gl {

/// What one frame consists of.
struct ScreenFrame {
  WindowSize size;
  Rect view;  ///< of the picture, in the units of the cursor
  ImVec4 background{};
  int font_generation = 0;
  ImDrawData* panels = nullptr;
};

/// Draws frames with the current OpenGL context into the bound framebuffer: picture, overlays,
/// panels. Textures are written only when what they show is another.
class Screen {
 public:
  static Result<std::unique_ptr<Screen>> create();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  void draw(const ScreenFrame& frame, const Results& results);

 private:
  explicit Screen(ImageRenderer renderer) : renderer_(std::move(renderer)) {}
  void update_textures(const Results& results);

  ImageRenderer renderer_;
  Texture picture_, overlay_;
  std::shared_ptr<const std::vector<std::uint32_t>> picture_shown_;
  std::shared_ptr<const Overlay> overlay_shown_;
  int font_generation_ = 0;
};

/// What is in the bound framebuffer: RGBA8, top row first, red in the lowest byte, opaque.
std::vector<std::uint32_t> read_pixels(int width, int height);

}  // namespace bspview::gl
