#include "app/viewer/panels/panels.h"

#include "app/viewer/panels/accuracy_panel.h"
#include "app/viewer/panels/build_panel.h"
#include "app/viewer/panels/help_overlay.h"
#include "app/viewer/panels/measures_panel.h"
#include "app/viewer/panels/menu_bar.h"
#include "app/viewer/panels/overlay_panel.h"
#include "app/viewer/panels/picture_panel.h"
#include "app/viewer/panels/ray_panel.h"
#include "app/viewer/panels/scene_panel.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/splitters.h"
#include "app/viewer/panels/status_bar.h"
#include "app/viewer/panels/viewport_panel.h"

namespace bspview {
namespace {

LayoutInput layout_input(const Ui& ui, Vec2 window, const State& state) {
  return {window, ui.scale, ImGui::GetFontSize() + ui.px(9), state.look.splits,
          state.panels_visible};
}

void left_column(const Ui& ui, const Rect& rect, const Results& results, State& state) {
  const RegionScope region("left", rect);
  scene_panel(ui, results, state);
  build_panel(ui, results, state);
  overlay_panel(ui, results, state);
  picture_panel(ui, state);
  accuracy_panel(ui, results, state);
}

void right_column(const Ui& ui, const Layout& layout, const Results& results, State& state) {
  {
    const RegionScope region("measures", layout.measures);
    measures_panel(ui, results, state);
  }
  const RegionScope region("ray", layout.ray);
  ray_panel(ui, results, state);
}

void bars(const Ui& ui, const Layout& layout, const Results& results, std::vector<Action>& actions,
          const State& state) {
  {
    const StyleScope padding(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), ui.px(4.5f)));
    const RegionScope region("menu", layout.menu, ImGuiWindowFlags_MenuBar | unscrolled | below);
    menu_bar(ui, results, state, actions);
  }
  const StyleScope padding(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(4)));
  const ColorScope background(ImGuiCol_WindowBg, ui.palette.window);
  const RegionScope region("status", layout.status, unscrolled | below);
  status_bar(ui, results);
}

}  // namespace

Layout layout_for(const Ui& ui, Vec2 window, const State& state) {
  return make_layout(layout_input(ui, window, state));
}

void draw_panels(const Ui& ui, Vec2 window, const Results& results, State& state,
                 std::vector<Action>& actions) {
  const LayoutInput input = layout_input(ui, window, state);
  const Layout layout = make_layout(input);
  state.hovered_step.reset();
  viewport_panel(ui, layout.view, results, state);
  if (state.panels_visible) {
    const StyleScope least(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    const StyleScope border(ImGuiStyleVar_WindowBorderSize, 1.0f);
    left_column(ui, layout.left, results, state);
    right_column(ui, layout, results, state);
    bars(ui, layout, results, actions, state);
    splitters(ui, input, layout, state.look.splits);
  }
  if (state.help_visible) state.help_visible = help_overlay(ui, {0.0f, 0.0f, window.x, window.y});
}

}  // namespace bspview
