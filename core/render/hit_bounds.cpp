#include "core/render/hit_bounds.h"

#include <algorithm>

#include "core/math/float_error.h"
#include "core/math/largest_coordinate.h"
#include "core/shape/polygon.h"
#include "core/shape/triangle.h"

namespace bspview {
namespace {

/// By how much the tests of round shapes in a box may be off.
double rounding_in(const Aabb& box) {
  return 0x1p-23 * largest_coordinate(box);
}

/// How far what counts as a hit may lie beside an object's box. Triangles are decided exactly, the
/// tests of round shapes round. Which rays a polygon encloses is decided exactly, too; they meet it
/// where its vertices are off its plane, at distances that double rounds: relatively where the
/// plane is one across an axis, which alone has no thickness.
double margin_around(const Scene& scene, std::uint32_t id, const Aabb& box) {
  const Object& object = scene.objects[id];
  if (object.kind == ObjectKind::triangle) return 0.0;
  if (object.kind != ObjectKind::polygon) return rounding_in(box);
  const PolygonPlane& plane = scene.planes[scene.faces[object.shape].plane];
  if (plane.thickness == 0.0) return 0.0;
  const Vec3d slopes = magnitudes(plane.normal);
  return 2.0 * plane.thickness / std::max({slopes.x, slopes.y, slopes.z}) +
         0x1p-44 * largest_coordinate(box);
}

Aabb grown(const Aabb& box, double margin) {
  Aabb more;
  for (int axis = 0; axis < 3; ++axis) {
    more.lo[axis] = round_down(double{box.lo[axis]} - margin);
    more.hi[axis] = round_up(double{box.hi[axis]} + margin);
  }
  return more;
}

}  // namespace

Aabb hit_bounds(const Scene& scene, std::uint32_t id) {
  const Aabb box = object_bounds(scene, id);
  return box.empty() ? box : grown(box, margin_around(scene, id, box));
}

Aabb hit_bounds(const Scene& scene, const ObjectPart& part) {
  return grown(part.box, margin_around(scene, part.object, part.box));
}

Aabb hit_bounds(const Scene& scene, std::uint32_t id, const Aabb& whole, const Aabb& cell) {
  constexpr std::size_t most_corners = 1024;  // more take long to clip, in branch after branch
  const Object& object = scene.objects[id];
  const Aabb overlap = intersection(whole, cell);
  const bool is_triangle = object.kind == ObjectKind::triangle;
  if (overlap == whole || !(is_triangle || object.kind == ObjectKind::polygon)) return overlap;
  const std::span<const Vec3> vertices = vertices_of(scene, scene.faces[object.shape]);
  if (is_triangle) return clip_triangle(vertices.data(), whole, cell);
  if (vertices.size() > most_corners) return overlap;
  const double margin = margin_around(scene, id, whole);
  const Aabb part = clip_polygon(vertices, grown(cell, margin));
  return part.empty() ? part : intersection(grown(part, margin), cell);
}

Aabb hit_bounds(const Scene& scene, std::span<const ObjectPart> parts) {
  Aabb all;
  const bool has_polygons = !scene.planes.empty();
  for (const ObjectPart& part : parts) all.grow(has_polygons ? hit_bounds(scene, part) : part.box);
  const bool has_round_shapes = !scene.spheres.empty() || !scene.cones.empty();
  if (has_polygons || !has_round_shapes || all.empty()) return all;
  return grown(all, rounding_in(all));  // no less than that of each
}

}  // namespace bspview
