#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/viewer/input_queue.h"
#include "app/viewer/widget_map.h"
#include "core/base/result.h"

namespace bspview {

/// One line of a script of input. Words are separated by spaces, # starts a comment.
///
///     wait                      until nothing is left to compute
///     move PLACE                the pointer; PLACE is X Y, or a widget's name as in --ui-map with
///                               or without the share of its width from the left: build.depth 0.3
///     press, release [right]    a mouse button
///     click PLACE               move, press and release
///     wheel STEPS
///     key CHORD                 Ctrl+Z, F1, B, Left
///     type TEXT                 characters, to the end of the line
///     drop FILE                 a file falls on the window
///     screenshot FILE, state FILE
struct ScriptStep {
  enum class Kind : std::uint8_t {
    wait,
    move,
    press,
    release,
    click,
    wheel,
    key,
    type,
    drop,
    screenshot,
    state
  };
  Kind kind = Kind::wait;
  std::string text;   ///< all after the command
  std::string place;  ///< "script.txt:3", for errors
};

/// Reads a script; errors name the line.
Result<std::vector<ScriptStep>> parse_script(std::string_view text, const std::string& file_name);

/// Where a PLACE is in a frame with these widgets.
Result<Vec2> find_place(const ScriptStep& step, const WidgetMap& widgets);

/// The events of a CHORD: all keys down, then up again.
Result<std::vector<InputEvent>> chord_events(const ScriptStep& step);

}  // namespace bspview
