#include "core/render/hit_bounds.h"

#include <algorithm>

namespace bspview {
namespace {

/// By how much the tests of round shapes and of polygons in a box may be off.
float rounding_in(const Aabb& box) {
  const Vec3 far = glm::max(magnitudes(box.lo), magnitudes(box.hi));
  return 0x1p-23f * largest_component(far);
}

/// How far what counts as a hit may lie beside an object's box. Triangles are decided exactly; the
/// tests of round shapes round, and polygons are met where their vertices are off their plane.
float margin_around(const Scene& scene, std::uint32_t id, const Aabb& box) {
  const Object& object = scene.objects[id];
  if (object.kind == ObjectKind::triangle) return 0.0f;
  const float rounding = rounding_in(box);
  if (object.kind != ObjectKind::polygon) return rounding;
  const PolygonPlane& plane = scene.planes[scene.faces[object.shape].plane];
  const Vec3d slopes = magnitudes(plane.normal);
  return rounding +
         static_cast<float>(2.0 * plane.thickness / std::max({slopes.x, slopes.y, slopes.z}));
}

}  // namespace

Aabb hit_bounds(const Scene& scene, std::uint32_t id) {
  const Aabb box = object_bounds(scene, id);
  if (box.empty()) return box;
  const float margin = margin_around(scene, id, box);
  return margin > 0.0f ? Aabb{box.lo - margin, box.hi + margin} : box;
}

Aabb hit_bounds(const Scene& scene, const ObjectPart& part) {
  const float margin = margin_around(scene, part.object, part.box);
  return {part.box.lo - margin, part.box.hi + margin};
}

Aabb hit_bounds(const Scene& scene, std::span<const ObjectPart> parts) {
  Aabb all;
  const bool has_polygons = !scene.planes.empty();
  for (const ObjectPart& part : parts) all.grow(has_polygons ? hit_bounds(scene, part) : part.box);
  const bool has_round_shapes = !scene.spheres.empty() || !scene.cones.empty();
  if (has_polygons || !has_round_shapes || all.empty()) return all;
  const float margin = rounding_in(all);  // no less than that of each
  return {all.lo - margin, all.hi + margin};
}

}  // namespace bspview
