#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>

namespace bspview {

struct FirstHits;

/// Lets the overlay over a picture be drawn before that picture is gone on with: where the hand
/// waits for boxes, they need all cores for a few milliseconds, and shading takes many times that.
class OverlayTurn {
 public:
  /// Pictures wait no longer than this.
  explicit OverlayTurn(std::chrono::milliseconds longest = std::chrono::milliseconds(100))
      : longest_(longest) {}

  /// Whether overlays are asked for at all.
  void expect(bool overlays);
  /// The overlay over these hits is there, or will not be.
  void finish(std::shared_ptr<const FirstHits> hits);
  /// Returns when that was said of these hits or none is expected; false where a stop is requested
  /// before, or it takes too long.
  bool wait_for(const std::shared_ptr<const FirstHits>& hits, const std::stop_token& stop);

 private:
  const std::chrono::milliseconds longest_;
  std::mutex mutex_;  // guards all below
  std::condition_variable_any news_;
  bool expected_ = false;
  std::shared_ptr<const FirstHits> finished_;  // the last ones
};

}  // namespace bspview
