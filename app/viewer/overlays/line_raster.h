#pragma once

#include <optional>
#include <span>
#include <stop_token>

#include "app/viewer/overlays/layer.h"
#include "app/viewer/overlays/line_list.h"
#include "core/scene/camera.h"

namespace bspview {

/// What lines are seen with.
struct LineView {
  Camera camera;
  int width = 0, height = 0;  ///< pixels
  /// Frame::distance of a picture of that camera and size; empty: nothing hides a line.
  std::span<const float> distance;
  float hidden_alpha = 0.25f;  ///< factor of a line's alpha where a surface hides it
  int threads = 0;             ///< 0: every core; never changes the layer
};

/// Draws `lines` with anti-aliasing into a layer of the view's size.
///
/// The ray of a pixel has a direction of length 1 along the view axis, so its t and a line's depth
/// along that axis are the same measure. A line is hidden where it lies more than two pixel sides
/// (at its own depth) behind the surface, in the pixel it runs through and in the two beside it:
/// lines on a surface stay whole.
///
/// Where lines cross, the more opaque one wins and the later one among equals, so hidden lines
/// never pile up to a solid colour. The layer is the same for any number of threads. nullopt only
/// when `stop` was requested, which is polled per tile. O(lines + covered pixels).
[[nodiscard]] std::optional<Layer> draw_lines(std::span<const Line> lines, const LineView& view,
                                              std::stop_token stop = {});

}  // namespace bspview
