#pragma once

namespace bspview {

/// Adapts BoxPruning::min_pixels while the camera moves so that an overlay takes `budget_ms`:
/// feed the time of the last drawing, use the result for the next one. At rest use 1.
[[nodiscard]] float next_min_pixels(float min_pixels, float taken_ms, float budget_ms);

}  // namespace bspview
