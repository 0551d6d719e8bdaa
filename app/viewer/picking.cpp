#include "app/viewer/picking.h"

#include <cmath>

namespace bspview {
namespace {

constexpr float click_radius = 4.0f;          // units of the cursor
constexpr double click_seconds = 0.3;         // from press to release
constexpr double double_click_seconds = 0.4;  // from release to release

bool is_near(Vec2 a, Vec2 b) {
  return glm::length(a - b) < click_radius;
}

}  // namespace

Vec2 pixel_coordinates(const PictureRect& rect, Vec2 cursor) {
  return (cursor - rect.corner) / rect.extent *
         Vec2(static_cast<float>(rect.width), static_cast<float>(rect.height));
}

std::optional<Pixel> pixel_under(const PictureRect& rect, Vec2 cursor) {
  const Vec2 at = pixel_coordinates(rect, cursor);
  const bool inside = at.x >= 0.0f && at.y >= 0.0f && at.x < static_cast<float>(rect.width) &&
                      at.y < static_cast<float>(rect.height);
  if (!inside) return {};
  return Pixel{static_cast<int>(at.x), static_cast<int>(at.y)};
}

void PressTracker::press(Vec2 cursor, double time) {
  pressed_ = true;
  dragging_ = false;
  start_ = last_ = cursor;
  start_time_ = time;
}

Vec2 PressTracker::move(Vec2 cursor) {
  if (!pressed_) return Vec2(0.0f);
  dragging_ = dragging_ || !is_near(cursor, start_);
  if (!dragging_) return Vec2(0.0f);
  const Vec2 moved = cursor - last_;
  last_ = cursor;
  return moved;
}

PressTracker::Release PressTracker::release(Vec2 cursor, double time) {
  if (!pressed_) return Release::nothing;
  move(cursor);
  pressed_ = false;
  if (dragging_) {
    dragging_ = false;
    last_click_time_.reset();
    return Release::end_of_drag;
  }
  if (time - start_time_ >= click_seconds) return Release::nothing;
  const bool second = last_click_time_ && time - *last_click_time_ < double_click_seconds &&
                      is_near(start_, last_click_);
  last_click_time_ = second ? std::nullopt : std::optional(time);
  last_click_ = start_;
  return second ? Release::double_click : Release::click;
}

}  // namespace bspview
