#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <utility>

#include "app/viewer/overlay_turn.h"
#include "app/viewer/requests.h"
#include "core/base/result.h"

namespace bspview {

// The work behind each stage; see Stage::Work. Each publishes through `publish`.

template <class Value>
using Publish = std::function<void(std::shared_ptr<const Value>)>;

Result<void> open_scene(const SceneRequest& request, std::stop_token stop,
                        const Publish<LoadedScene>& publish);
Result<void> follow_rays(const PathRequest& request, std::stop_token stop,
                         const Publish<PixelRays>& publish);
Result<void> judge_picture(const AccuracyRequest& request, std::stop_token stop,
                           const Publish<Accuracy>& publish);
Result<void> take_times(const MeasureRequest& request, std::stop_token stop,
                        const Publish<Measures>& publish);

/// Builds trees, and while only their limits or the ratio of their costs change, cuts them from a
/// larger one. The builders that costs stop early keep what that needs from their first tree on,
/// which takes up to 7 % of its time; the others, whose trees grow without end, only once a limit
/// has been changed. While someone turns at what a large tree of `sah` has to be built anew for
/// every time, that of `sah-binned` is published first.
class TreeWork {
 public:
  TreeWork();
  Result<void> operator()(const TreeRequest& request, std::stop_token stop,
                          const Publish<BuiltTree>& publish);
  /// Whether `wish` can be cut from what is being built. From any thread.
  bool serves(const TreeRequest& wish) const;
  /// Share of the work under way that is done; 0 where none is. From any thread.
  double progress() const;

 private:
  class Grower;
  class Rest;
  std::shared_ptr<Grower> grower_;  // shared by copies
};

/// Renders progressively. A tree never changes what is seen, only what it costs: when nothing else
/// is new, the better pixels of the picture before stay. What its rays hit is then looked at first,
/// and the overlay of that is waited for.
class PictureWork {
 public:
  explicit PictureWork(std::shared_ptr<OverlayTurn> turn = std::make_shared<OverlayTurn>())
      : turn_(std::move(turn)) {}
  Result<void> operator()(const PictureRequest& request, std::stop_token stop,
                          const Publish<Picture>& publish);

 private:
  std::shared_ptr<OverlayTurn> turn_;
  std::shared_ptr<const Picture> last_;
};

/// Draws the overlays; thins the boxes out while the camera moves.
class OverlayWork {
 public:
  explicit OverlayWork(std::shared_ptr<OverlayTurn> turn = std::make_shared<OverlayTurn>())
      : turn_(std::move(turn)) {}
  Result<void> operator()(const OverlayRequest& request, std::stop_token stop,
                          const Publish<Overlay>& publish);

 private:
  std::shared_ptr<OverlayTurn> turn_;
  float min_pixels_ = 1.0f;  // see next_min_pixels
};

}  // namespace bspview
