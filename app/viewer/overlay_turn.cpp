#include "app/viewer/overlay_turn.h"

#include <utility>

namespace bspview {

void OverlayTurn::expect(bool overlays) {
  const std::lock_guard lock(mutex_);
  expected_ = overlays;
  news_.notify_all();
}

void OverlayTurn::finish(std::shared_ptr<const FirstHits> hits) {
  const std::lock_guard lock(mutex_);
  finished_ = std::move(hits);
  news_.notify_all();
}

bool OverlayTurn::wait_for(const std::shared_ptr<const FirstHits>& hits,
                           const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  return news_.wait_for(lock, stop, longest_, [&] { return !expected_ || finished_ == hits; });
}

}  // namespace bspview
