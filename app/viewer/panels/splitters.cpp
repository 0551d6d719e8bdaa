#include "app/viewer/panels/splitters.h"

#include "app/viewer/panels/scopes.h"

namespace bspview {
namespace {

constexpr float grip = 6.0f;  // design pixels

enum class Direction { across, down };

/// Movement of the pointer along `direction` while it drags the border.
float splitter(const Ui& ui, const char* name, const Rect& border, Direction direction) {
  const RegionScope region(name, border, ImGuiWindowFlags_NoBackground | unscrolled);
  ImGui::InvisibleButton("grip", {border.width, border.height});
  ui.note(name);
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (active || hovered) {
    ImGui::SetMouseCursor(direction == Direction::across ? ImGuiMouseCursor_ResizeEW
                                                         : ImGuiMouseCursor_ResizeNS);
    const float inset = ui.px(grip / 3);
    const ImVec2 in = direction == Direction::across ? ImVec2(inset, 0) : ImVec2(0, inset);
    ImGui::GetWindowDrawList()->AddRectFilled(
        {border.x + in.x, border.y + in.y}, {border.right() - in.x, border.bottom() - in.y},
        ImGui::GetColorU32(active ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered));
  }
  if (!active) return 0.0f;
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  return direction == Direction::across ? delta.x : delta.y;
}

}  // namespace

void splitters(const Ui& ui, const LayoutInput& input, const Layout& layout, Splits& splits) {
  const StyleScope padding(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const StyleScope least(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  const float width = ui.px(grip), half = width / 2;
  Splits dragged = clamp_splits(input);
  const Rect& left = layout.left;
  const Rect& measures = layout.measures;
  dragged.left += splitter(ui, "splitter.left", {left.right() - half, left.y, width, left.height},
                           Direction::across) /
                  ui.scale;
  dragged.right -= splitter(ui, "splitter.right", {measures.x - half, left.y, width, left.height},
                            Direction::across) /
                   ui.scale;
  dragged.ray -= splitter(ui, "splitter.ray",
                          {measures.x + half, layout.ray.y - half, measures.width - half, width},
                          Direction::down) /
                 left.height;
  if (dragged != clamp_splits(input)) splits = dragged;
}

}  // namespace bspview
