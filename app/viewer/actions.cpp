#include "app/viewer/actions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/viewer/key.h"

namespace bspview {
namespace {

constexpr float scale_step = 0.125f;

struct KeyName {
  int key;
  const char* name;
};
constexpr std::array key_names{
    KeyName{key::escape, "Esc"},
    KeyName{key::tab, "Tab"},
    KeyName{key::f1, "F1"},
    KeyName{key::f11, "F11"},
    KeyName{key::f12, "F12"},
    KeyName{key::left, "←"},
    KeyName{key::right, "→"},
    KeyName{key::up, "↑"},
    KeyName{key::down, "↓"},
    KeyName{key::keypad_add, "+"},
    KeyName{key::keypad_subtract, "-"},
    KeyName{'=', "+"},
};

bool is_function_key(const Chord& chord) {
  return chord.key >= key::f1 && chord.key <= key::f12;
}

/// How often a chord was pressed in this frame. Of one key that is once at most (see InputQueue),
/// but characters may come in numbers.
std::ptrdiff_t count_presses(const Chord& chord, bool repeats, const ImGuiIO& io) {
  if (io.WantTextInput && !is_function_key(chord)) return 0;
  if (chord.character != '\0')
    return std::ranges::count(io.InputQueueCharacters, static_cast<ImWchar>(chord.character));
  const bool pressed =
      chord.ctrl == io.KeyCtrl && !io.KeyAlt && ImGui::IsKeyPressed(chord.key, repeats);
  return pressed ? 1 : 0;
}

void move_pick(State& state, int columns, int rows) {
  if (!state.pick) return;
  Pick& pick = *state.pick;
  pick.pixel.column = std::clamp(pick.pixel.column + columns, 0, pick.width - 1);
  pick.pixel.row = std::clamp(pick.pixel.row + rows, 0, pick.height - 1);
  state.ray = {};
}

void change_depth(BuildParams& params, int by, std::size_t objects) {
  params.max_depth = std::clamp(effective_depth(params, objects) + by, 0, depth_cap);
}

void change_scale(Look& look, float scale) {
  look.scale = std::clamp(scale, least_scale, largest_scale);
}

/// Esc: away with what is in the way, then with the selection.
void cancel(State& state) {
  if (state.help_visible)
    state.help_visible = false;
  else if (!state.notice.empty())
    state.notice.clear();
  else if (state.ray.step >= 0)
    state.ray.step = -1;
  else
    state.pick.reset();
}

bool change_picture(Action action, State& state) {
  switch (action) {
    case Action::boxes:
      state.boxes.visible = !state.boxes.visible;
      return true;
    case Action::path:
      state.path_visible = !state.path_visible;
      return true;
    case Action::pick_left:
      move_pick(state, -1, 0);
      return true;
    case Action::pick_right:
      move_pick(state, 1, 0);
      return true;
    case Action::pick_up:
      move_pick(state, 0, -1);
      return true;
    case Action::pick_down:
      move_pick(state, 0, 1);
      return true;
    default:
      return false;
  }
}

bool change_window(Action action, State& state) {
  Look& look = state.look;
  switch (action) {
    case Action::panels:
      state.panels_visible = !state.panels_visible;
      return true;
    case Action::larger:
      change_scale(look, look.scale + scale_step);
      return true;
    case Action::smaller:
      change_scale(look, look.scale - scale_step);
      return true;
    case Action::natural_size:
      look.scale = 1.0f;
      return true;
    case Action::theme:
      look.theme = look.theme == Theme::dark ? Theme::light : Theme::dark;
      return true;
    case Action::help:
      state.help_visible = !state.help_visible;
      return true;
    default:
      return false;
  }
}

bool change_build(Action action, State& state, std::size_t objects) {
  BuildParams& build = state.build;
  switch (action) {
    case Action::deeper:
      change_depth(build, 1, objects);
      return true;
    case Action::shallower:
      change_depth(build, -1, objects);
      return true;
    case Action::larger_leaf:
      build.leaf_size = std::min(build.leaf_size, std::numeric_limits<int>::max() - 1) + 1;
      return true;
    case Action::smaller_leaf:
      build.leaf_size = std::max(1, build.leaf_size - 1);
      return true;
    default:
      return false;
  }
}

}  // namespace

const char* title_of(Menu menu) {
  constexpr std::array titles{"File", "Edit", "View", "Window", "Help"};
  return titles[static_cast<std::size_t>(menu)];
}

std::string name_of(const Chord& chord) {
  if (chord.character != '\0') return {chord.character};
  const auto found = std::ranges::find(key_names, chord.key, &KeyName::key);
  const std::string name = found != key_names.end() ? std::string(found->name)
                                                    : std::string(1, static_cast<char>(chord.key));
  return (chord.ctrl ? "Ctrl+" : "") + name;
}

std::span<const KeyBinding> key_bindings() {
  static const std::vector<KeyBinding> bindings{
      {Action::open, Menu::file, "Open a scene", {{.key = 'O', .ctrl = true}}},
      {Action::screenshot,
       Menu::file,
       "Save a picture of the window",
       {{.key = 'S', .ctrl = true}, {.key = key::f12}}},
      {Action::quit, Menu::file, "Quit", {{.key = 'Q', .ctrl = true}}},
      {Action::undo, Menu::edit, "Undo a change of the tree", {{.key = 'Z', .ctrl = true}}},
      {Action::redo, Menu::edit, "Redo it", {{.key = 'Y', .ctrl = true}}},
      {Action::shallower, Menu::edit, "Maximal depth down", {{.character = '['}}},
      {Action::deeper, Menu::edit, "Maximal depth up", {{.character = ']'}}},
      {Action::smaller_leaf, Menu::edit, "Leaf size down", {{.character = '{'}}},
      {Action::larger_leaf, Menu::edit, "Leaf size up", {{.character = '}'}}},
      {Action::frame, Menu::view, "Frame the whole scene", {{.key = 'F'}}},
      {Action::reset, Menu::view, "Back to the scene's own view", {{.key = 'R'}}},
      {Action::boxes, Menu::view, "Leaf boxes", {{.key = 'B'}}},
      {Action::path, Menu::view, "Path of the picked ray", {{.key = 'P'}}},
      {Action::pick_left, Menu::view, "Pick the pixel to the left", {{.key = key::left}}, true},
      {Action::pick_right, Menu::view, "Pick the pixel to the right", {{.key = key::right}}, true},
      {Action::pick_up, Menu::view, "Pick the pixel above", {{.key = key::up}}, true},
      {Action::pick_down, Menu::view, "Pick the pixel below", {{.key = key::down}}, true},
      {Action::cancel, Menu::view, "Cancel, then deselect", {{.key = key::escape}}},
      {Action::panels, Menu::window, "Panels", {{.key = key::tab}}},
      {Action::full_screen, Menu::window, "Full screen", {{.key = key::f11}}},
      {Action::larger,
       Menu::window,
       "Larger text",
       {{.key = '=', .ctrl = true}, {.key = key::keypad_add, .ctrl = true}}},
      {Action::smaller,
       Menu::window,
       "Smaller text",
       {{.key = '-', .ctrl = true}, {.key = key::keypad_subtract, .ctrl = true}}},
      {Action::natural_size, Menu::window, "Natural text size", {{.key = '0', .ctrl = true}}},
      {Action::theme, Menu::window, "Light or dark", {}},
      {Action::help, Menu::help, "Keys and mouse", {{.key = key::f1}, {.character = '?'}}},
  };
  return bindings;
}

std::string chords_text(const KeyBinding& binding) {
  std::vector<std::string> names;
  for (const Chord& chord : binding.chords)
    if (std::ranges::find(names, name_of(chord)) == names.end()) names.push_back(name_of(chord));
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::span<const MouseBinding> mouse_bindings() {
  static constexpr std::array bindings{
      MouseBinding{"Click", "Pick a pixel and follow its rays"},
      MouseBinding{"Double click", "Centre the view on a point"},
      MouseBinding{"Drag", "Turn about the centre"},
      MouseBinding{"Right or Shift + drag", "Move sideways"},
      MouseBinding{"Wheel", "Move towards the pointer, or away"},
      MouseBinding{"Drop a file", "Open it"},
  };
  return bindings;
}

std::vector<Action> pressed_actions(const ImGuiIO& io) {
  std::vector<Action> actions;
  for (const KeyBinding& binding : key_bindings())
    for (const Chord& chord : binding.chords)
      actions.insert(actions.end(),
                     static_cast<std::size_t>(count_presses(chord, binding.repeats, io)),
                     binding.action);
  return actions;
}

bool change_state(Action action, State& state, std::size_t objects) {
  if (action == Action::cancel) {
    cancel(state);
    return true;
  }
  if (action == Action::open) {
    state.focus_source = state.panels_visible = true;
    state.look.closed_sections.erase("Scene");
    return true;
  }
  return change_picture(action, state) || change_window(action, state) ||
         change_build(action, state, objects);
}

}  // namespace bspview
