#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/eval/reference.h"
#include "core/render/render.h"

namespace bspview {

/// What the rays of a pixel got wrong.
enum class PixelFault : std::uint8_t {
  unchecked,  ///< not looked at yet
  none,       ///< also where either answer can be defended
  lost,       ///< the eye ray went through a surface that is surely there
  phantom,    ///< the eye ray hit something that is not there
  self_hit    ///< a shadow ray was blocked by the surface that it left, which is not in its way
};

/// The faults of a picture; row-major, top row first.
struct PixelFaults {
  int width = 0, height = 0;
  std::vector<PixelFault> pixels;
  std::size_t checked = 0, lost = 0, phantom = 0, self_hit = 0;  ///< pixels
  bool complete = false;                                         ///< every pixel was checked
};

/// A picture that is judged. All outlive the call.
struct JudgedPicture {
  const World& world;
  const Reference& reference;  ///< of the world's scene
  const Camera& camera;
  const RenderParams& params;
};

/// Traces the ray through every pixel centre, and the shadow rays from its hit, as the params say,
/// and judges them by the reference. Every 16th, 8th, 4th, 2nd and every pixel in both directions
/// in turn; calls publish(faults) after each, on the calling thread. Returns when done or when
/// `stop` is requested (polled per tile). Tens of microseconds a pixel.
void find_pixel_faults(const JudgedPicture& picture, std::stop_token stop,
                       const std::function<void(const PixelFaults&)>& publish);

}  // namespace bspview
