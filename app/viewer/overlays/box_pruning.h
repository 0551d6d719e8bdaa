#pragma once

#include "app/viewer/overlays/screen_transform.h"
#include "core/math/aabb.h"

namespace bspview {

/// What need not be drawn: subtrees outside the picture, and the inside of nodes that are smaller
/// than `min_pixels` on screen (they are drawn as if they were leaves, with their greatest value).
struct BoxPruning {
  ScreenTransform transform;
  float min_pixels = 1.0f;
};

enum class OnScreen { outside, small, large };

/// Conservative: `outside` and `small` are certain, `large` may be either.
[[nodiscard]] OnScreen find_on_screen(const BoxPruning& pruning, const Aabb& cell);

/// The line looks shorter than `min_pixels`, seen from the side at its middle.
[[nodiscard]] bool is_short(const BoxPruning& pruning, Vec3 from, Vec3 to);

}  // namespace bspview
