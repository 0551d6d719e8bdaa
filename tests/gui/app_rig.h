#pragma once

#include <functional>
#include <string>

#include "app/viewer/app.h"
#include "app/viewer/bell.h"
#include "app/viewer/interface.h"

namespace bspview {

inline constexpr WindowSize small_window{960, 600, 960, 600, 1.0f};

/// The whole viewer but its window and OpenGL: input goes in, frames are counted, state comes out.
class AppRig {
 public:
  explicit AppRig(State state, WindowSize size = small_window) : size_(size), app_(std::move(state), bell_.ringer()) {}

  App& app() { return app_; }
  const State& state() const { return app_.state(); }
  const Results& results() const { return app_.results(); }

  void frame() {
    const Look& look = app_.state().look;
    interface_.set_look(look.theme, look.scale);
    interface_.begin_frame(size_, 1.0f / 60);
    app_.frame(interface_, size_);
    interface_.end_frame();
  }

  /// Frames until all input is seen.
  void act() {
    do frame();
    while (!interface_.input().empty());
    for (int i = 0; i < 3; ++i) frame();
  }

  /// Frames until `done`; gives up after a minute.
  bool wait_for(const std::function<bool()>& done) {
    for (int i = 0; i < 6000; ++i) {
      frame();
      if (done()) return true;
      bell_.wait(std::chrono::milliseconds(10));
    }
    return false;
  }
  bool settle() {
    return wait_for([&] { return !app_.busy() && !app_.next_frame_in(); });
  }

  Vec2 middle_of(const std::string& widget) const {
    const Rect& rect = app_.widgets().at(widget);
    return {rect.x + rect.width / 2, rect.y + rect.height / 2};
  }
  /// Point of a widget, `share` of its width from the left.
  Vec2 point_of(const std::string& widget, float share) const {
    const Rect& rect = app_.widgets().at(widget);
    return {rect.x + share * rect.width, rect.y + rect.height / 2};
  }

  void move(Vec2 to) { push(InputEvent::move(to)); }
  void press(int button = 0) { push(InputEvent::button(button, true)); }
  void release(int button = 0) { push(InputEvent::button(button, false)); }
  void click(Vec2 at) {
    move(at);
    act();
    press();
    release();
    act();
  }
  void key(int code) {
    push(InputEvent::key(code, true));
    push(InputEvent::key(code, false));
    act();
  }
  void type(char character) {
    push(InputEvent::text(character));
    act();
  }
  void push(const InputEvent& event) { interface_.input().push(event); }

 private:
  WindowSize size_;
  Bell bell_;
  Interface interface_;
  App app_;
};

}  // namespace bspview
