#pragma once

#include <cstddef>
#include <optional>

#include "core/math/vec.h"

namespace bspview {

/// Where the picture is on screen.
struct PictureRect {
  Vec2 corner{0.0f};          ///< upper left, in the cursor's coordinates
  Vec2 extent{1.0f};          ///< in the cursor's coordinates
  int width = 1, height = 1;  ///< pixels of the picture (more than extent on HiDPI screens)
};

/// Pixel coordinates of the cursor, also outside the picture.
[[nodiscard]] Vec2 pixel_coordinates(const PictureRect& rect, Vec2 cursor);

/// A pixel of the picture; column from the left, row from the top.
struct Pixel {
  int column = 0, row = 0;
  bool operator==(const Pixel&) const = default;
  std::size_t index(int width) const { return static_cast<std::size_t>(row) * width + column; }
  Vec2 centre() const {
    return {static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f};
  }
};

/// The pixel under the cursor; nullopt beside the picture.
[[nodiscard]] std::optional<Pixel> pixel_under(const PictureRect& rect, Vec2 cursor);

/// Tells clicks from drags for one mouse button: a click moves less than 4 units of the cursor and
/// lasts less than 0.3 s. Times in seconds, of any clock.
class PressTracker {
 public:
  enum class Release { nothing, click, double_click, end_of_drag };

  void press(Vec2 cursor, double time);
  /// Movement to drag by since the last call: nothing until the press has become a drag, then
  /// everything since the press.
  Vec2 move(Vec2 cursor);
  Release release(Vec2 cursor, double time);

  bool pressed() const { return pressed_; }
  bool dragging() const { return dragging_; }
  Vec2 pressed_at() const { return start_; }

 private:
  bool pressed_ = false, dragging_ = false;
  Vec2 start_{0.0f}, last_{0.0f};
  double start_time_ = 0.0;
  std::optional<double> last_click_time_;
  Vec2 last_click_{0.0f};
};

}  // namespace bspview
