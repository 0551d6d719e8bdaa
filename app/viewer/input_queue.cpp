#include "app/viewer/input_queue.h"

#include "app/viewer/key.h"

namespace bspview {
namespace {

bool is_modifier(int code) {
  return code >= key::left_shift && code <= key::right_super;
}

/// What this frame has changed so far.
struct Changes {
  std::set<int> keys, buttons;
  bool pressed = false;  // a button, or a key that is no modifier
  bool moved = false;
  bool chord = false;  // Ctrl and a key, which may turn the keyboard over to a text field

  bool allow(const InputEvent& event) const {
    if (chord) return false;
    switch (event.kind) {
      case InputEvent::Kind::key:
        return allow_key(event.code);
      case InputEvent::Kind::button:
        return allow_button(event);
      case InputEvent::Kind::move:
        return buttons.empty();
      default:
        return true;
    }
  }

  /// Modifiers stay as they were when something was pressed.
  bool allow_key(int code) const { return !keys.contains(code) && !(is_modifier(code) && pressed); }

  /// What is dragged goes where it was let go.
  bool allow_button(const InputEvent& event) const {
    return !buttons.contains(event.code) && (event.down || !moved);
  }
};

bool known(const InputEvent& event) {
  if (event.kind == InputEvent::Kind::key) return event.code >= 0 && event.code < key::count;
  if (event.kind == InputEvent::Kind::button) return event.code >= 0 && event.code < 5;
  return true;
}

bool is_ctrl_down(const ImGuiIO& io) {
  return io.KeysDown[key::left_control] || io.KeysDown[key::right_control];
}

void apply(const InputEvent& event, ImGuiIO& io, Changes& changes) {
  switch (event.kind) {
    case InputEvent::Kind::key:
      io.KeysDown[event.code] = event.down;
      changes.keys.insert(event.code);
      changes.pressed |= event.down && !is_modifier(event.code);
      changes.chord |= event.down && !is_modifier(event.code) && is_ctrl_down(io);
      break;
    case InputEvent::Kind::button:
      io.MouseDown[event.code] = event.down;
      changes.buttons.insert(event.code);
      changes.pressed |= event.down;
      break;
    case InputEvent::Kind::text:
      io.AddInputCharacter(static_cast<unsigned>(event.code));
      break;
    case InputEvent::Kind::move:
      io.MousePos = {event.amount.x, event.amount.y};
      changes.moved = true;
      break;
    case InputEvent::Kind::wheel:
      io.MouseWheelH += event.amount.x;
      io.MouseWheel += event.amount.y;
      break;
  }
}

}  // namespace

void InputQueue::feed(ImGuiIO& io) {
  if (held_frames_ > 0) {
    --held_frames_;
    return;
  }
  Changes changes;
  while (!events_.empty() && changes.allow(events_.front())) {
    if (known(events_.front())) apply(events_.front(), io, changes);
    events_.pop_front();
  }
  io.KeyCtrl = is_ctrl_down(io);
  io.KeyShift = io.KeysDown[key::left_shift] || io.KeysDown[key::right_shift];
  io.KeyAlt = io.KeysDown[key::left_alt] || io.KeysDown[key::right_alt];
  io.KeySuper = io.KeysDown[key::left_super] || io.KeysDown[key::right_super];
}

void map_keys(ImGuiIO& io) {
  const auto map = [&io](ImGuiKey key, int code) { io.KeyMap[key] = code; };
  map(ImGuiKey_Tab, key::tab);
  map(ImGuiKey_LeftArrow, key::left);
  map(ImGuiKey_RightArrow, key::right);
  map(ImGuiKey_UpArrow, key::up);
  map(ImGuiKey_DownArrow, key::down);
  map(ImGuiKey_PageUp, key::page_up);
  map(ImGuiKey_PageDown, key::page_down);
  map(ImGuiKey_Home, key::home);
  map(ImGuiKey_End, key::end);
  map(ImGuiKey_Insert, key::insert);
  map(ImGuiKey_Delete, key::del);
  map(ImGuiKey_Backspace, key::backspace);
  map(ImGuiKey_Space, ' ');
  map(ImGuiKey_Enter, key::enter);
  map(ImGuiKey_KeyPadEnter, key::keypad_enter);
  map(ImGuiKey_Escape, key::escape);
  for (const auto& [name, letter] : {std::pair{ImGuiKey_A, 'A'},
                                     {ImGuiKey_C, 'C'},
                                     {ImGuiKey_V, 'V'},
                                     {ImGuiKey_X, 'X'},
                                     {ImGuiKey_Y, 'Y'},
                                     {ImGuiKey_Z, 'Z'}})
    map(name, letter);
}

}  // namespace bspview
