#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/viewer/state.h"

namespace bspview {

/// Everything that a key or a menu can do.
enum class Action : std::uint8_t {
  open,
  screenshot,
  quit,
  undo,
  redo,
  deeper,
  shallower,
  larger_leaf,
  smaller_leaf,
  frame,
  reset,
  boxes,
  path,
  pick_left,
  pick_right,
  pick_up,
  pick_down,
  cancel,
  panels,
  full_screen,
  larger,
  smaller,
  natural_size,
  theme,
  help,
};

enum class Menu : std::uint8_t { file, edit, view, window, help };
const char* title_of(Menu menu);

/// A key as it is pressed: a key number (key.h) with or without Ctrl, or a character, wherever the
/// user's keyboard has it.
struct Chord {
  int key = 0;
  bool ctrl = false;
  char character = '\0';
};
std::string name_of(const Chord& chord);  ///< "Ctrl+S", "F12", "?"

/// One line of the help, the menus and the keyboard.
struct KeyBinding {
  Action action;
  Menu menu;
  const char* text;
  std::vector<Chord> chords;  ///< may be empty; the menus show the first one
  bool repeats = false;       ///< while the key is held
};

/// The one table of them all.
std::span<const KeyBinding> key_bindings();
std::string chords_text(const KeyBinding& binding);  ///< "Ctrl+S, F12"

/// What the mouse does, for the help.
struct MouseBinding {
  const char* gesture;
  const char* text;
};
std::span<const MouseBinding> mouse_bindings();

/// What the keys of this frame ask for. While a text is typed, only the keys without a meaning
/// there count.
std::vector<Action> pressed_actions(const ImGuiIO& io);

/// Carries out what concerns the state alone; false when the action needs more than that.
bool change_state(Action action, State& state, std::size_t objects);

}  // namespace bspview
