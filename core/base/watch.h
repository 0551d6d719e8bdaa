#pragma once

#include <functional>
#include <stop_token>
#include <utility>

namespace bspview {

/// How whoever asked for long work follows it: may stop it, and is told how far it is.
struct Watch {
  Watch() = default;
  Watch(std::stop_token token) : stop(std::move(token)) {}

  bool stopped() const { return stop.stop_requested(); }
  void advance(double share) const {
    if (progress) progress(share);
  }

  std::stop_token stop;
  /// Called with how much more is done, from several threads; all calls add up to 1, or to the
  /// number of runs for work that says so. Below 0: what was done is to be done again.
  std::function<void(double more)> progress;
};

}  // namespace bspview
