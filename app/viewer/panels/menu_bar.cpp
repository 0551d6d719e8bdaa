#include "app/viewer/panels/menu_bar.h"

#include <string>

#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

bool is_on(Action action, const State& state) {
  switch (action) {
    case Action::boxes:
      return state.boxes.visible;
    case Action::path:
      return state.path_visible;
    case Action::panels:
      return state.panels_visible;
    case Action::help:
      return state.help_visible;
    default:
      return false;
  }
}

void items(const Ui& ui, Menu menu, const State& state, std::vector<Action>& actions) {
  for (const KeyBinding& binding : key_bindings()) {
    if (binding.menu != menu) continue;
    const std::string chord = binding.chords.empty() ? "" : name_of(binding.chords.front());
    if (ImGui::MenuItem(binding.text, chord.c_str(), is_on(binding.action, state)))
      actions.push_back(binding.action);
    ui.note(std::string("menu.") + binding.text);
  }
}

void scene_title(const Ui& ui, const Results& results) {
  if (!results.scene) return;
  const std::string title = results.scene->scene.name + "  ·  " +
                            counted(results.scene->counts.objects, "object", "objects");
  const float width = ImGui::CalcTextSize(title.c_str()).x;
  const float at = ImGui::GetWindowWidth() - width - ui.px(10);
  if (at > ImGui::GetCursorPosX()) ImGui::SetCursorPosX(at);
  dim_text(ui, title);
}

}  // namespace

void menu_bar(const Ui& ui, const Results& results, const State& state,
              std::vector<Action>& actions) {
  if (!ImGui::BeginMenuBar()) return;
  for (const Menu menu : {Menu::file, Menu::edit, Menu::view, Menu::window, Menu::help}) {
    const bool open = ImGui::BeginMenu(title_of(menu));
    ui.note(std::string("menu.") + title_of(menu));
    if (!open) continue;
    items(ui, menu, state, actions);
    ImGui::EndMenu();
  }
  scene_title(ui, results);
  ImGui::EndMenuBar();
}

}  // namespace bspview
