#include "app/viewer/panels/help_overlay.h"

#include "app/viewer/actions.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

void heading(const Ui& ui, const char* text) {
  const FontScope bold(ui.fonts.bold);
  ImGui::TextUnformatted(text);
}

void row(const Ui& ui, const std::string& keys, const char* text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(keys.c_str());
  ImGui::TableNextColumn();
  dim_text(ui, text);
}

void keys_of(const Ui& ui, Menu menu) {
  heading(ui, title_of(menu));
  const TableScope table(title_of(menu), 2, ImGuiTableFlags_SizingFixedFit);
  if (!table) return;
  for (const KeyBinding& binding : key_bindings())
    if (binding.menu == menu && !binding.chords.empty())
      row(ui, chords_text(binding), binding.text);
}

void mouse_rows(const Ui& ui) {
  heading(ui, "Mouse");
  const TableScope table("mouse", 2, ImGuiTableFlags_SizingFixedFit);
  if (!table) return;
  for (const MouseBinding& binding : mouse_bindings()) row(ui, binding.gesture, binding.text);
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
  if (const TableScope columns("columns", 2, ImGuiTableFlags_SizingFixedFit); columns) {
    ImGui::TableNextColumn();
    for (const Menu menu : {Menu::view, Menu::help}) keys_of(ui, menu);
    mouse_rows(ui);
    ImGui::TableNextColumn();
    for (const Menu menu : {Menu::file, Menu::edit, Menu::window}) keys_of(ui, menu);
    if (button(ui, {"help.close", "Close", "Esc"})) open = false;
  }
  ImGui::SetWindowFocus();
  ImGui::End();
  return open;
}

}  // namespace bspview
