#pragma once

#include <functional>
#include <stop_token>

#include "app/viewer/requests.h"
#include "core/base/result.h"

namespace bspview {

// The work behind each stage; see Stage::Work. Each publishes through `publish`.

template <class Value>
using Publish = std::function<void(std::shared_ptr<const Value>)>;

Result<void> open_scene(const SceneRequest& request, std::stop_token stop,
                        const Publish<LoadedScene>& publish);
Result<void> grow_tree(const TreeRequest& request, std::stop_token stop,
                       const Publish<BuiltTree>& publish);
Result<void> follow_rays(const PathRequest& request, std::stop_token stop,
                         const Publish<PixelRays>& publish);
Result<void> judge_picture(const AccuracyRequest& request, std::stop_token stop,
                           const Publish<Accuracy>& publish);
Result<void> take_times(const MeasureRequest& request, std::stop_token stop,
                        const Publish<Measures>& publish);

/// Renders progressively. A tree never changes what is seen, only what it costs: when nothing else
/// is new, the better pixels of the picture before stay.
class PictureWork {
 public:
  Result<void> operator()(const PictureRequest& request, std::stop_token stop,
                          const Publish<Picture>& publish);

 private:
  std::shared_ptr<const Picture> last_;
};

/// Draws the overlays; thins the boxes out while the camera moves.
class OverlayWork {
 public:
  Result<void> operator()(const OverlayRequest& request, std::stop_token stop,
                          const Publish<Overlay>& publish);

 private:
  float min_pixels_ = 1.0f;  // see next_min_pixels
};

}  // namespace bspview
