#include "app/eval/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bspview {
namespace {

constexpr int bar_width = 30;         // characters
constexpr double first_after = 0.5;   // seconds: short work shows no bar
constexpr double redraw_every = 0.1;  // seconds

std::string rate_text(double per_second) {
  if (per_second >= 1e6) return fmt::format("{:.1f} M/s", per_second / 1e6);
  if (per_second >= 1e3) return fmt::format("{:.1f} k/s", per_second / 1e3);
  return fmt::format("{:.1f}/s", per_second);
}

std::string time_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::max(0.0, std::ceil(seconds)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole % 3600 / 60);
}

}  // namespace

std::string format_progress(const std::string& what, const ProgressState& state) {
  const double share = state.total > 0.0 ? std::clamp(state.done / state.total, 0.0, 1.0) : 1.0;
  // Shares of tiles that add up to a whole may fall short of it by rounding.
  constexpr double rounding = 1e-9;
  const auto marks = static_cast<std::size_t>((share + rounding) * bar_width);
  std::string text = fmt::format("{} [{:-<{}}] {:3.0f} %", what, std::string(marks, '#'), bar_width,
                                 std::floor((share + rounding) * 100.0));
  if (!(state.done > 0.0 && state.seconds > 0.0)) return text;
  const double rate = state.done / state.seconds;
  const double left = std::max(0.0, state.total - state.done);
  return text + fmt::format("  {}  {} left", rate_text(rate), time_text(left / rate - rounding));
}

Progress::Progress(std::string what, double total, Mode mode)
    : what_(std::move(what)),
      state_{.total = total},
      shown_(mode == Mode::shown && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::add(double done) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  state_.done += done;
  draw();
}

void Progress::draw() {
  state_.seconds = timer_.seconds();
  const double due = drawn_ ? last_drawn_ + redraw_every : first_after;
  if (state_.seconds < due) return;
  last_drawn_ = state_.seconds;
  drawn_ = true;
  fmt::print(stderr, "\r{}\033[K", format_progress(what_, state_));
  std::fflush(stderr);
}

}  // namespace bspview
