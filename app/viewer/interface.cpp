#include "app/viewer/interface.h"

#include <algorithm>

namespace bspview {
namespace {

constexpr float least_step = 1e-5f;  // seconds; Dear ImGui insists on time that passes

}  // namespace

Interface::Interface() : context_(ImGui::CreateContext()) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // our settings keep what is worth keeping, in the user's folder
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  map_keys(io);
  set_look(Theme::dark, 1.0f);
}

Interface::~Interface() {
  ImGui::DestroyContext(context_);
}

void Interface::set_look(Theme theme, float scale) {
  if (scale != scale_) {
    fonts_ = load_fonts(scale);
    ++font_generation_;
  } else if (theme == theme_) {
    return;
  }
  apply_theme(theme, scale);
  palette_ = palette_of(theme);
  theme_ = theme;
  scale_ = scale;
}

void Interface::begin_frame(const WindowSize& size, float seconds_since_last) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
  io.DisplayFramebufferScale = {
      static_cast<float>(size.pixel_width) / static_cast<float>(std::max(1, size.width)),
      static_cast<float>(size.pixel_height) / static_cast<float>(std::max(1, size.height))};
  io.DeltaTime = std::max(seconds_since_last, least_step);
  input_.feed(io);
  ImGui::NewFrame();
}

ImDrawData* Interface::end_frame() {
  ImGui::Render();
  return ImGui::GetDrawData();
}

}  // namespace bspview
