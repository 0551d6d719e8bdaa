#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/eval/pixel_faults.h"

namespace bspview {

/// One way of tracing rays: what it takes and how often it errs.
struct TradeOffPoint {
  Arithmetic arithmetic = Arithmetic::exact;
  Traversal traversal = Traversal::robust;
  double nanoseconds = 0.0;  ///< a ray, on one thread (time_rays): the median of the rounds so far
  std::size_t rays = 0;      ///< judged
  std::size_t wrong = 0;     ///< of those: lost or phantom

  /// Wrong rays a million; where none was found, the upper bound of 3 in `rays` (95 %).
  double wrong_a_million() const;
};

/// Every arithmetic with every traversal, on the same eye rays (at most 4096, evenly over the
/// picture). All are judged once by the reference and timed in rounds, one after the other; calls
/// publish(points) after every round, on the calling thread. Returns when done or when `stop` is
/// requested.
void measure_trade_offs(const JudgedPicture& picture, std::stop_token stop,
                        const std::function<void(const std::vector<TradeOffPoint>&)>& publish);

}  // namespace bspview
