#pragma once

#include "core/render/intersect.h"

namespace bspview {

/// The surface at a hit, turned towards the ray that hit it.
struct Surface {
  Vec3d point{0.0};
  Vec3d normal{0.0};          ///< geometric, unit, on the ray's side
  Vec3d shading_normal{0.0};  ///< unit; differs from `normal` on patches only
  Vec3d error{0.0};           ///< bound on how far `point` may be off the surface, per axis
  bool from_behind = false;   ///< the ray came to the back of the object
  const Material* material = nullptr;
};

Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit);

/// Origin for a ray that leaves the surface towards `direction`: surely on that side of it. After
/// Waechter & Binder and pbrt: moved by the error bound along the normal, then rounded outwards.
Vec3 leaving_origin(const Surface& surface, Vec3d direction);

/// The ray from the surface towards `direction`.
inline Ray leaving_ray(const Surface& surface, Vec3d direction, OffsetRule rule) {
  if (rule == OffsetRule::fixed) return {Vec3(surface.point), Vec3(direction), fixed_t_min};
  return {leaving_origin(surface, direction), Vec3(direction)};
}

/// The ray from the surface up to just before the light: one that lies in a surface is not hidden
/// by it.
inline Ray shadow_ray(const Surface& surface, const Light& light, OffsetRule rule) {
  Ray ray = leaving_ray(surface, Vec3d(light.position) - surface.point, rule);
  ray.direction = light.position - ray.origin;
  ray.t_max = 1.0f - 0x1p-20f;
  return ray;
}

}  // namespace bspview
