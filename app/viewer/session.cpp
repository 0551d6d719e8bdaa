#include "app/viewer/session.h"

#include <algorithm>
#include <utility>

#include "core/render/image_io.h"

namespace bspview {
namespace {

/// The largest scale at which the panels still find room in the window, or 1 where that is more.
float largest_fitting_scale(const WindowSize& size) {
  constexpr float least_width = 880.0f, least_height = 520.0f;  // of a window at scale 1
  return std::max(1.0f, std::min(static_cast<float>(size.width) / least_width,
                                 static_cast<float>(size.height) / least_height));
}

}  // namespace

Result<std::unique_ptr<Session>> Session::create(State state, std::function<void()> wake) {
  auto interface = std::make_unique<Interface>();
  Result<std::unique_ptr<gl::Screen>> screen = gl::Screen::create();
  if (!screen) return screen.error();
  return std::unique_ptr<Session>(
      new Session(std::move(state), std::move(wake), std::move(interface), *std::move(screen)));
}

Session::Session(State state, std::function<void()> wake, std::unique_ptr<Interface> interface,
                 std::unique_ptr<gl::Screen> screen)
    : interface_(std::move(interface)),
      screen_(std::move(screen)),
      app_(std::move(state), std::move(wake)) {}

void Session::frame(const WindowSize& size, float seconds) {
  const Look& look = app_.state().look;
  interface_->set_look(look.theme,
                       std::min(look.scale * size.content_scale, largest_fitting_scale(size)));
  interface_->begin_frame(size, seconds);
  app_.frame(*interface_, size);
  ImDrawData* panels = interface_->end_frame();
  screen_->draw({.size = size,
                 .view = app_.view(),
                 .background = interface_->palette().window,
                 .font_generation = interface_->font_generation(),
                 .panels = panels},
                app_.results());
}

Result<void> save_screenshot(const WindowSize& size, const std::filesystem::path& file) {
  const std::vector<std::uint32_t> pixels = gl::read_pixels(size.pixel_width, size.pixel_height);
  Image image{size.pixel_width, size.pixel_height, {}};
  image.pixels.reserve(pixels.size());
  for (const std::uint32_t pixel : pixels)
    image.pixels.push_back(Vec3(pixel & 0xff, pixel >> 8 & 0xff, pixel >> 16 & 0xff) / 255.0f);
  return save_png(image, file);
}

}  // namespace bspview
