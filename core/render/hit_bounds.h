#pragma once

#include <span>

#include "core/bsp/deferred_leaf.h"
#include "core/scene/scene.h"

namespace bspview {

// Boxes of what rays can hit of an object, or of a part of it: a little more than the object where
// its test rounds.
Aabb hit_bounds(const Scene& scene, std::uint32_t id);
Aabb hit_bounds(const Scene& scene, const ObjectPart& part);
/// Of what of an object lies in `cell`, or a little larger; `whole`: of all of it.
Aabb hit_bounds(const Scene& scene, std::uint32_t id, const Aabb& whole, const Aabb& cell);
Aabb hit_bounds(const Scene& scene, std::span<const ObjectPart> parts);  ///< around all of them

}  // namespace bspview
