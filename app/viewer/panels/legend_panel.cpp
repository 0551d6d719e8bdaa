#include "app/viewer/panels/legend_panel.h"

#include <algorithm>

namespace bspview {
namespace {

constexpr float bar_width = 190.0f, bar_height = 9.0f, margin = 12.0f, padding = 10.0f;

void draw_bar(ImDrawList& list, const Rect& bar, const Legend& legend) {
  const float step = bar.width / static_cast<float>(legend.colors.size() - 1);
  for (std::size_t i = 0; i + 1 < legend.colors.size(); ++i) {
    const float x = bar.x + step * static_cast<float>(i);
    const ImU32 left = legend.colors[i], right = legend.colors[i + 1];
    list.AddRectFilledMultiColor({x, bar.y}, {x + step, bar.bottom()}, left, right, right, left);
  }
}

void draw_ticks(const Ui& ui, ImDrawList& list, const Rect& bar, const Legend& legend) {
  const ImU32 color = ImGui::GetColorU32(ui.palette.dim_text);
  float free_from = bar.x - ui.px(padding);
  for (const LegendTick& tick : legend.ticks) {
    const float x = bar.x + tick.position * bar.width;
    const float width = ImGui::CalcTextSize(tick.label.c_str()).x;
    const float left = std::clamp(x - width / 2, bar.x, bar.right() - width);
    list.AddLine({x, bar.bottom()}, {x, bar.bottom() + ui.px(3)}, color);
    if (left < free_from) continue;
    list.AddText({left, bar.bottom() + ui.px(3)}, color, tick.label.c_str());
    free_from = left + width + ui.px(5);
  }
}

}  // namespace

void legend_panel(const Ui& ui, const Rect& rect, const Legend& legend) {
  if (legend.colors.size() < 2) return;
  const float line = ImGui::GetTextLineHeight();
  const float height = 2 * line + ui.px(bar_height + 2 * padding);
  const float width = ui.px(bar_width + 2 * padding);
  const Rect box{rect.x + ui.px(margin), rect.bottom() - ui.px(margin) - height, width, height};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({box.x, box.y}, {box.right(), box.bottom()},
                     ImGui::GetColorU32(ui.palette.panel), ui.px(4));
  list.AddText({box.x + ui.px(padding), box.y + ui.px(padding - 3)},
               ImGui::GetColorU32(ui.palette.text), legend.title.c_str());
  const Rect bar{box.x + ui.px(padding), box.y + ui.px(padding) + line, ui.px(bar_width),
                 ui.px(bar_height)};
  draw_bar(list, bar, legend);
  draw_ticks(ui, list, bar, legend);
  ui.widgets["legend"] = box;
}

}  // namespace bspview
