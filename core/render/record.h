#pragma once

#include <stop_token>
#include <vector>

#include "core/render/tracer.h"

namespace bspview {

/// Every ray of the picture that render_image would make, tile after tile, in the order traced.
Result<std::vector<RecordedRay>> record_rays(const World& world, const Camera& camera,
                                             const RenderParams& params, const Watch& watch = {});

/// What a replay does with each recorded ray.
enum class Replay {
  walk,   ///< walks without object tests: over the nodes of the binary tree that the ray visited,
          ///< or through wide nodes up to where it ended
  enter,  ///< reads the ray and finds its interval in the root box, no more
};

/// Replays the rays on the threads of `params` until `stop` is requested; the result (nodes visited
/// last, added up) keeps the work from being left out.
std::uint64_t replay(const World& world, const RenderParams& params,
                     std::span<const RecordedRay> rays, Replay what, std::stop_token stop = {});

}  // namespace bspview
