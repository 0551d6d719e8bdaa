#pragma once

#include <mutex>
#include <string>

#include "core/base/timer.h"

namespace bspview {

/// How far some work is.
struct ProgressState {
  double done = 0.0, total = 0.0;
  double seconds = 0.0;  ///< since its start
};

/// "rays [#####-----]  50 %  1.2 M/s  3 s left", at most 79 characters for a `what` of one word.
std::string format_progress(const std::string& what, const ProgressState& state);

/// A progress bar on stderr for work that takes longer than a moment; silent when stderr is no
/// terminal or the user asked for quiet. Safe to call from several threads.
class Progress {
 public:
  enum class Mode { shown, quiet };
  static Mode mode(bool is_quiet) { return is_quiet ? Mode::quiet : Mode::shown; }

  Progress(std::string what, double total, Mode mode);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< takes the bar away

  void add(double done);

 private:
  void draw();

  std::string what_;
  ProgressState state_;
  bool shown_;
  bool drawn_ = false;
  double last_drawn_ = 0.0;  // seconds
  Timer timer_;
  std::mutex mutex_;
};

}  // namespace bspview
