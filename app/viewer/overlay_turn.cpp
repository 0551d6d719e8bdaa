#include "app/viewer/overlay_turn.h"

#include <utility>

namespace bspview {

void OverlayTurn::expect(bool overlays) {
  std::shared_ptr<const FirstHits> old;  // freed when the lock is
  const std::lock_guard lock(mutex_);
  expected_ = overlays;
  if (!overlays) old.swap(finished_);
  news_.notify_all();
}

void OverlayTurn::finish(std::shared_ptr<const FirstHits> hits) {
  {
    const std::lock_guard lock(mutex_);
    finished_.swap(hits);
  }
  news_.notify_all();  // and then free the ones before: the interface never waits for that
}

bool OverlayTurn::wait_for(const std::shared_ptr<const FirstHits>& hits,
                           const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  return news_.wait_for(lock, stop, longest_, [&] { return !expected_ || finished_ == hits; });
}

}  // namespace bspview
