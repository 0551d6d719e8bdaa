#pragma once

#include "core/render/intersect.h"
#include "core/render/render.h"

namespace bspview {

/// closest_hit or, with `any`, any_hit by the binary trees of world.lazy: each part that the ray
/// enters is built. For rays that wide nodes cannot take, and to have all parts that counting rays
/// will enter. The leaf of the answer stays no_leaf.
Hit find_in_parts(const World& world, const Ray& ray, SideRule rule, bool any);

/// Builds all parts that the rays of a picture enter in the binary tree, which are some more than
/// those that the picture itself builds: its counts are then those of the whole tree. Errors as
/// render_image.
Result<void> build_for_counts(const World& world, const Camera& camera, const RenderParams& params,
                              const Watch& watch = {});

}  // namespace bspview
