#pragma once

#include <imgui.h>

#include <cstdint>
#include <deque>
#include <set>

#include "core/math/vec.h"

namespace bspview {

/// Something the user did.
struct InputEvent {
  enum class Kind : std::uint8_t { key, text, move, button, wheel };
  Kind kind = Kind::move;
  int code = 0;       ///< key: see key.h; button: 0 left, 1 right, 2 middle; text: code point
  bool down = false;  ///< key and button
  Vec2 amount{0.0f};  ///< move: position in window coordinates; wheel: steps

  static InputEvent key(int code, bool down) { return {Kind::key, code, down, {}}; }
  static InputEvent text(int code_point) { return {Kind::text, code_point, true, {}}; }
  static InputEvent move(Vec2 position) { return {Kind::move, 0, false, position}; }
  static InputEvent button(int code, bool down) { return {Kind::button, code, down, {}}; }
  static InputEvent wheel(Vec2 steps) { return {Kind::wheel, 0, false, steps}; }
};

/// Hands events to Dear ImGui in the order in which they happened, without losing one: what would
/// undo something of the same frame (the release of a key that was just pressed, of Ctrl after it,
/// the pointer's way after a click, the end of a drag) waits for the next frame.
class InputQueue {
 public:
  void push(const InputEvent& event) { events_.push_back(event); }
  bool empty() const { return events_.empty(); }

  /// Call once before every ImGui::NewFrame.
  void feed(ImGuiIO& io);

  /// Keeps everything back for the next `frames` frames, while a text field takes the keyboard:
  /// Dear ImGui drops what is typed in the meantime.
  void hold(int frames) { held_frames_ = frames; }

 private:
  std::deque<InputEvent> events_;
  int held_frames_ = 0;
};

/// Tells Dear ImGui which of our key numbers are its editing keys.
void map_keys(ImGuiIO& io);

}  // namespace bspview
