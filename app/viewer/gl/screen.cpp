#include "app/viewer/gl/screen.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>

namespace bspview::gl {
namespace {

PixelRect to_pixels(const Rect& rect, const WindowSize& size) {
  const float x_scale = static_cast<float>(size.pixel_width) / static_cast<float>(size.width);
  const float y_scale = static_cast<float>(size.pixel_height) / static_cast<float>(size.height);
  const auto round = [](float v) { return static_cast<int>(std::lround(v)); };
  const int bottom = round(rect.bottom() * y_scale);
  return {round(rect.x * x_scale), size.pixel_height - bottom, round(rect.width * x_scale),
          round(rect.height * y_scale)};
}

}  // namespace

Result<std::unique_ptr<Screen>> Screen::create() {
  Result<ImageRenderer> renderer = ImageRenderer::create();
  if (!renderer) return renderer.error();
  if (!ImGui_ImplOpenGL3_Init("#version 330 core"))
    return Error{"the interface cannot be drawn with this OpenGL"};
  return std::unique_ptr<Screen>(new Screen(*std::move(renderer)));
}

Screen::~Screen() {
  ImGui_ImplOpenGL3_Shutdown();
}

void Screen::update_textures(const Results& results) {
  if (results.picture && results.picture->pixels != picture_shown_) {
    picture_shown_ = results.picture->pixels;
    const RenderParams& params = results.picture->request.params;
    picture_.write(*picture_shown_, params.width, params.height);
  }
  if (results.overlay && results.overlay != overlay_shown_) {
    const Layer& layer = results.overlay->layer;
    overlay_.write(layer.pixels, layer.width, layer.height);
  }
  overlay_shown_ = results.overlay;
}

void Screen::draw(const ScreenFrame& frame, const Results& results) {
  if (font_generation_ != frame.font_generation) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    font_generation_ = frame.font_generation;
  }
  ImGui_ImplOpenGL3_NewFrame();
  update_textures(results);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, frame.size.pixel_width, frame.size.pixel_height);
  glClearColor(frame.background.x, frame.background.y, frame.background.z, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  const PixelRect view = to_pixels(frame.view, frame.size);
  if (results.picture) renderer_.draw(picture_, view, Blend::replace);
  if (results.overlay) renderer_.draw(overlay_, view, Blend::over);
  ImGui_ImplOpenGL3_RenderDrawData(frame.panels);
}

std::vector<std::uint32_t> read_pixels(int width, int height) {
  std::vector<std::uint32_t> upwards(static_cast<std::size_t>(width) * height);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upwards.data());
  std::vector<std::uint32_t> pixels(upwards.size());
  for (int row = 0; row < height; ++row)
    std::transform(upwards.begin() + static_cast<std::ptrdiff_t>(height - 1 - row) * width,
                   upwards.begin() + static_cast<std::ptrdiff_t>(height - row) * width,
                   pixels.begin() + static_cast<std::ptrdiff_t>(row) * width,
                   [](std::uint32_t pixel) { return pixel | 0xff000000u; });
  return pixels;
}

}  // namespace bspview::gl
