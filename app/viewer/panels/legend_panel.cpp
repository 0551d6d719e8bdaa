#include "app/viewer/panels/legend_panel.h"

#include <algorithm>
#include <array>
#include <string>

#include "app/viewer/overlays/ray_path.h"

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

/// The box of a legend with room for `height`, title included.
Rect draw_box(const Ui& ui, const Rect& rect, float height, const std::string& title) {
  const Rect box{rect.x + ui.px(margin), rect.bottom() - ui.px(margin) - height,
                 ui.px(bar_width + 2 * padding), height};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({box.x, box.y}, {box.right(), box.bottom()},
                     ImGui::GetColorU32(ui.palette.panel), ui.px(4));
  list.AddText({box.x + ui.px(padding), box.y + ui.px(padding - 3)},
               ImGui::GetColorU32(ui.palette.text), title.c_str());
  return box;
}

Rect above(const Rect& rect, const Rect& box) {
  return {rect.x, rect.y, rect.width, box.y - rect.y};
}

/// Rows of a sample and what it stands for.
class SampleRows {
 public:
  SampleRows(const Ui& ui, const Rect& box)
      : ui_(ui), x_(box.x + ui.px(padding)), y_(box.y + ui.px(padding) + line()) {}

  static float line() { return ImGui::GetTextLineHeight(); }

  void add_line(std::uint32_t color, const char* text) {
    const float middle = y_ + line() / 2;
    list_.AddLine({x_, middle}, {x_ + width(), middle}, color, ui_.px(2.5f));
    add_text(text);
  }
  void add_mark(std::uint32_t color, const char* text) {
    list_.AddNgon({x_ + width() / 2, y_ + line() / 2}, ui_.px(5), color, 4, ui_.px(2));
    add_text(text);
  }
  void add_cells(const char* text) {
    constexpr int cells = 3;
    const float size = width() / cells;
    for (int i = 0; i < cells; ++i) {
      const float x = x_ + size * static_cast<float>(i);
      const std::uint32_t color = cell_color(static_cast<float>(i) / (cells - 1));
      list_.AddRect({x, y_ + ui_.px(3)}, {x + size - ui_.px(2), y_ + line() - ui_.px(2)}, color);
    }
    add_text(text);
  }

 private:
  float width() const { return ui_.px(30); }
  void add_text(const char* text) {
    const ImU32 color = ImGui::GetColorU32(ui_.palette.dim_text);
    list_.AddText({x_ + width() + ui_.px(8), y_}, color, text);
    y_ += line();
  }

  const Ui& ui_;
  ImDrawList& list_ = *ImGui::GetWindowDrawList();
  float x_, y_;
};

}  // namespace

Rect legend_panel(const Ui& ui, const Rect& rect, const Legend& legend) {
  if (legend.colors.size() < 2) return rect;
  const float line = ImGui::GetTextLineHeight();
  const Rect box = draw_box(ui, rect, 2 * line + ui.px(bar_height + 2 * padding), legend.title);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rect bar{box.x + ui.px(padding), box.y + ui.px(padding) + line, ui.px(bar_width),
                 ui.px(bar_height)};
  draw_bar(list, bar, legend);
  draw_ticks(ui, list, bar, legend);
  ui.widgets["legend"] = box;
  return above(rect, box);
}

Rect path_legend(const Ui& ui, const Rect& rect, std::span<const PathRay> rays) {
  struct Kind {
    RayKind kind;
    const char* text;
  };
  constexpr std::array kinds{Kind{RayKind::primary, "eye ray"},
                             Kind{RayKind::reflected, "reflected rays"},
                             Kind{RayKind::refracted, "refracted rays"},
                             Kind{RayKind::shadow, "shadow rays, to the lights"}};
  const auto occurs = [&](const Kind& kind) {
    return std::any_of(rays.begin(), rays.end(),
                       [&](const PathRay& ray) { return ray.kind == kind.kind; });
  };
  const auto lines = 3 + std::count_if(kinds.begin(), kinds.end(), occurs);
  const Rect box =
      draw_box(ui, rect, SampleRows::line() * static_cast<float>(lines) + ui.px(2 * padding),
               "Picked pixel");
  SampleRows rows(ui, box);
  for (const Kind& kind : kinds)
    if (occurs(kind)) rows.add_line(ray_color(kind.kind), kind.text);
  rows.add_cells("cells, from first to last");
  rows.add_mark(hit_color(), "hit of the selected ray");
  ui.widgets["legend.path"] = box;
  return above(rect, box);
}

}  // namespace bspview
