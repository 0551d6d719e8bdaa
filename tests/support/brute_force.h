#pragma once

#include "core/render/intersect.h"

namespace bspview::test {

/// The nearest hit by testing every object: the oracle of every tree and traversal.
inline Hit brute_force(const Scene& scene, const Ray& ray, SideRule sides = SideRule::two_sided) {
  const RayQuery query(ray, reach_of(scene_bounds(scene), ray.origin));
  Hit best;
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    const double t = hit_object(scene, id, query, sides);
    if (t < best.t) best = {t, id, no_leaf};
  }
  return best;
}

}  // namespace bspview::test
