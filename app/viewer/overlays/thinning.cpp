#include "app/viewer/overlays/thinning.h"

#include <algorithm>
#include <cmath>

namespace bspview {

float next_min_pixels(float min_pixels, float taken_ms, float budget_ms) {
  constexpr float finest = 1.0f, coarsest = 64.0f;
  // The number of cells on screen falls with about the square of their size. Steps are at most a
  // factor of two so that one slow drawing does not empty the overlay.
  const float factor = std::clamp(std::sqrt(taken_ms / budget_ms), 0.5f, 2.0f);
  return std::clamp(min_pixels * factor, finest, coarsest);
}

}  // namespace bspview
