#include "app/viewer/panels/viewport_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/viewer/overlays/legend.h"
#include "app/viewer/panels/legend_panel.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

Vec2 to_vec(const ImVec2& v) {
  return {v.x, v.y};
}

/// The mouse over one picture.
struct Pointer {
  PictureRect picture;
  Vec2 cursor;
  const Results& results;

  Vec2 pixel() const { return pixel_coordinates(picture, cursor); }
  float depth() const;
};

/// Distance of the surface under the pointer along the view axis; inf: none.
float Pointer::depth() const {
  constexpr float none = std::numeric_limits<float>::infinity();
  const std::optional<Pixel> under = pixel_under(picture, cursor);
  if (!under || !results.picture) return none;
  const RenderParams& params = results.picture->request.params;
  if (params.width != picture.width || params.height != picture.height) return none;
  return results.picture->first_hits->distance[under->index(picture.width)];
}

void pick(const Pointer& pointer, State& state) {
  const std::optional<Pixel> under = pixel_under(pointer.picture, pointer.cursor);
  if (!under) return;
  state.pick =
      Pick{*under, state.view.camera->camera(), pointer.picture.width, pointer.picture.height};
  state.ray = {};
}

void recentre(const Pointer& pointer, State& state) {
  const float depth = pointer.depth();
  if (depth == std::numeric_limits<float>::infinity()) return;
  const PrimaryRays rays(state.view.camera->camera(), pointer.picture.width,
                         pointer.picture.height);
  const Vec2 pixel = pointer.pixel();
  state.view.camera->recentre(rays.ray(pixel.x, pixel.y).at(depth));
}

void start_press(const Pointer& pointer, View& view) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(0) && !io.KeyShift) view.press.press(pointer.cursor, ImGui::GetTime());
  if (ImGui::IsMouseClicked(1) || (ImGui::IsMouseClicked(0) && io.KeyShift)) {
    view.pan_from = pointer.pixel();
    view.pan_depth = pointer.depth();
  }
}

void follow_press(const Pointer& pointer, State& state) {
  View& view = state.view;
  if (!view.press.pressed()) return;
  const float pixels_per_unit =
      static_cast<float>(pointer.picture.width) / std::max(1.0f, pointer.picture.extent.x);
  const Vec2 drag = view.press.move(pointer.cursor) * pixels_per_unit;
  if (drag != Vec2(0.0f)) view.camera->orbit(drag, view.size);
  if (ImGui::IsMouseDown(0)) return;
  switch (view.press.release(pointer.cursor, ImGui::GetTime())) {
    case PressTracker::Release::click:
      return pick(pointer, state);
    case PressTracker::Release::double_click:
      return recentre(pointer, state);
    default:
      return;
  }
}

void follow_pan(const Pointer& pointer, View& view) {
  if (!view.pan_from) return;
  const Vec2 pixel = pointer.pixel();
  if (pixel != *view.pan_from) view.camera->pan(*view.pan_from, pixel, view.pan_depth, view.size);
  view.pan_from = pixel;
  if (!ImGui::IsMouseDown(0) && !ImGui::IsMouseDown(1)) view.pan_from.reset();
}

void use_mouse(const Rect& rect, const Results& results, State& state) {
  View& view = state.view;
  const Pointer pointer{
      {{rect.x, rect.y}, {rect.width, rect.height}, view.size.width, view.size.height},
      to_vec(ImGui::GetIO().MousePos),
      results};
  if (ImGui::IsItemHovered()) {
    start_press(pointer, view);
    const float wheel = ImGui::GetIO().MouseWheel;
    if (wheel != 0.0f) view.camera->dolly(wheel, pointer.pixel(), pointer.depth(), view.size);
  }
  follow_press(pointer, state);
  follow_pan(pointer, view);
}

void notice(const Ui& ui, const Rect& rect, const std::string& text) {
  const float wrap = rect.width - ui.px(60);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  const ImVec2 at{rect.x + (rect.width - size.x) / 2, rect.y + ui.px(16)};
  const ImVec2 pad{ui.px(12), ui.px(7)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 lo{at.x - pad.x, at.y - pad.y}, hi{at.x + size.x + pad.x, at.y + size.y + pad.y};
  list.AddRectFilled(lo, hi, ImGui::GetColorU32(ui.palette.panel), ui.px(4));
  list.AddRect(lo, hi, ImGui::GetColorU32(ui.palette.line), ui.px(4));
  list.AddText(nullptr, 0.0f, at, ImGui::GetColorU32(ui.palette.text), text.c_str(), nullptr, wrap);
}

void legends(const Ui& ui, Rect rect, const Results& results, const State& state) {
  const BoxView& boxes = state.boxes;
  if (boxes.visible && boxes.color_by != LeafColor::plain && results.tree)
    rect =
        legend_panel(ui, rect,
                     make_legend(leaf_color_scale(results.tree->stats, boxes.color_by, boxes.map),
                                 legend_title(boxes.color_by)));
  if (state.path_visible && results.rays) path_legend(ui, rect, results.rays->rays);
}

}  // namespace

void viewport_panel(const Ui& ui, const Rect& rect, const Results& results, State& state) {
  const StyleScope padding(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const RegionScope region("view", rect, ImGuiWindowFlags_NoBackground | unscrolled | below);
  if (rect.width < 1.0f || rect.height < 1.0f) return;
  ImGui::InvisibleButton("picture", {rect.width, rect.height},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.note("view");
  if (state.view.camera) use_mouse(rect, results, state);
  if (!results.scene && !results.scene_busy)
    notice(ui, rect, "Drop a scene file here, or choose a standard scene on the left.");
  legends(ui, rect, results, state);
  if (!state.notice.empty()) notice(ui, rect, state.notice);
}

}  // namespace bspview
