#pragma once

#include <chrono>
#include <functional>
#include <semaphore>

namespace bspview {

/// Lets a thread sleep until others have news for it.
class Bell {
 public:
  /// For Stage and App; the bell outlives them.
  std::function<void()> ringer() {
    return [this] { rung_.release(); };
  }
  /// Returns when it was rung since the last call, or after `longest`.
  void wait(std::chrono::milliseconds longest) {
    if (!rung_.try_acquire_for(longest)) return;
    while (rung_.try_acquire()) {
    }
  }

 private:
  std::counting_semaphore<> rung_{0};
};

}  // namespace bspview
