#include "app/viewer/panels/help_overlay.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/viewer/actions.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

constexpr float key_gap = 18.0f, column_gap = 36.0f;  // design pixels

struct HelpRow {
  std::string keys;
  const char* text;
};

std::vector<HelpRow> rows_of(Menu menu) {
  std::vector<HelpRow> rows;
  for (const KeyBinding& binding : key_bindings())
    if (binding.menu == menu && !binding.chords.empty())
      rows.push_back({chords_text(binding), binding.text});
  return rows;
}

std::vector<HelpRow> mouse_rows() {
  std::vector<HelpRow> rows;
  for (const MouseBinding& binding : mouse_bindings())
    rows.push_back({binding.gesture, binding.text});
  return rows;
}

void block(const Ui& ui, const char* title, const std::vector<HelpRow>& rows) {
  {
    const FontScope bold(ui.fonts.bold);
    ImGui::TextUnformatted(title);
  }
  float width = 0.0f;
  for (const HelpRow& row : rows) width = std::max(width, ImGui::CalcTextSize(row.keys.c_str()).x);
  const float from = ImGui::GetCursorPosX();
  for (const HelpRow& row : rows) {
    ImGui::TextUnformatted(row.keys.c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(from + width + ui.px(key_gap));
    dim_text(ui, row.text);
  }
  ImGui::Dummy({0.0f, ui.px(4)});
}

void columns(const Ui& ui) {
  ImGui::BeginGroup();
  block(ui, title_of(Menu::view), rows_of(Menu::view));
  block(ui, "Mouse", mouse_rows());
  ImGui::EndGroup();
  ImGui::SameLine(0.0f, ui.px(column_gap));
  ImGui::BeginGroup();
  for (const Menu menu : {Menu::file, Menu::edit, Menu::window, Menu::help})
    block(ui, title_of(menu), rows_of(menu));
  ImGui::EndGroup();
}

}  // namespace

bool help_overlay(const Ui& ui, const Rect& window) {
  ImGui::SetNextWindowPos({window.x + window.width / 2, window.y + window.height / 2},
                          ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {0.96f * window.width, 0.94f * window.height});
  const StyleScope padding(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(18), ui.px(14)));
  const StyleScope border(ImGuiStyleVar_WindowBorderSize, ui.px(1));
  const StyleScope rounding(ImGuiStyleVar_WindowRounding, ui.px(6));
  bool open = true;
  ImGui::Begin("##help", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
  columns(ui);
  if (button(ui, {"help.close", "Close", ""})) open = false;
  ImGui::SetWindowFocus();
  ImGui::End();
  return open;
}

}  // namespace bspview
