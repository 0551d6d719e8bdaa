#include "core/eval/stress/subject.h"

#include "core/render/hits.h"

namespace bspview::stress {
namespace {

Hit closest(const World& world, const Ray& ray, RayCost& cost) {
  if (world.accelerator != nullptr) return fast_closest_hit(world, ray, SideRule::two_sided);
  CountObserver count(cost);
  return closest_hit(world, ray, {}, count);
}

bool occluded(const World& world, const Ray& ray) {
  if (world.accelerator != nullptr) {
    return fast_any_hit(world, ray, SideRule::two_sided) != no_index;
  }
  NoObserver none;
  return any_hit(world, ray, {}, none) != no_index;
}

double shape(const Scene& scene, std::uint32_t object, const Ray& ray, const Aabb& all) {
  return hit_object(scene, object, RayQuery(ray, reach_of(all, ray.origin)), SideRule::two_sided);
}

}  // namespace

const Subject& default_subject() {
  static constexpr Subject subject{
      .closest = closest,
      .occluded = occluded,
      .shape = shape,
      .edge = edge_area,
      .leaving = leaving_origin,
      .bounds = object_bounds,
      .clip = clip_polygon,
  };
  return subject;
}

}  // namespace bspview::stress
