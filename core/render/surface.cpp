#include "core/render/surface.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/float_error.h"

namespace bspview {
namespace {

/// Unit normal of the object's front, as its record says.
Vec3d front_normal(const Scene& scene, const Object& object, Vec3d point) {
  switch (object.kind) {
    case ObjectKind::sphere: {
      const Sphere& sphere = scene.spheres[object.shape];
      const Vec3d outward = glm::normalize(point - Vec3d(sphere.centre));
      return sphere.radius < 0.0f ? -outward : outward;
    }
    case ObjectKind::cone: {
      const Cone& cone = scene.cones[object.shape];
      const Vec3d outward = cone_normal(cone, point);
      return cone.base_radius < 0.0f || cone.apex_radius < 0.0f ? -outward : outward;
    }
    case ObjectKind::polygon:
      return glm::normalize(scene.planes[scene.faces[object.shape].plane].normal);
    case ObjectKind::triangle:
      break;
  }
  const Vec3* corners = &scene.vertices[scene.faces[object.shape].first_vertex];
  return glm::normalize(triangle_normal(corners[0], corners[1], corners[2]));
}

/// How far the hit point may be off the vertices' layer, and they off it, along the normal.
double thickness_of(const Scene& scene, const Object& object) {
  if (object.kind != ObjectKind::polygon) return 0.0;
  const PolygonPlane& plane = scene.planes[scene.faces[object.shape].plane];
  return 2.0 * plane.thickness / glm::length(plane.normal);
}

/// The normals of a patch at the hit, interpolated.
Vec3d patch_normal(const Scene& scene, const Face& face, const Ray& ray, Vec3d point) {
  const auto normals = std::span(scene.normals).subspan(face.first_normal, face.vertex_count);
  const std::span<const Vec3> vertices = vertices_of(scene, face);
  if (face.vertex_count == 3) {
    const Vec2 w = triangle_weights(ray, vertices.data());
    return Vec3d((1.0f - w.x - w.y) * normals[0]) + Vec3d(w.x * normals[1]) +
           Vec3d(w.y * normals[2]);
  }
  std::vector<float> weights(face.vertex_count);
  mean_value_coordinates(vertices, Vec3(point), weights);
  Vec3d normal(0.0);
  for (std::size_t i = 0; i < normals.size(); ++i) normal += Vec3d(weights[i] * normals[i]);
  return normal;
}

/// A float beyond x in the direction of an offset that led to x: the second from it on, or, if it
/// is no float, on the far side of it.
float moved_out(double x, double offset) {
  if (offset == 0.0) return static_cast<float>(x);
  // Seen so that the direction is up. Which way it is cannot be foretold: no branch asks for it.
  const double y = std::copysign(1.0, offset) * x;
  const auto near = static_cast<float>(y);
  const float size = std::abs(near);
  float out;
  if (size > 0x1p-120f && size < 0x1p120f) [[likely]] {
    const std::int32_t steps = 1 + static_cast<std::int32_t>(near < y);
    const std::int32_t up = 1 - 2 * static_cast<std::int32_t>(std::signbit(near));
    out = std::bit_cast<float>(std::bit_cast<std::int32_t>(near) + up * steps);
  } else {
    out = next_up(round_up(y));
  }
  return std::copysign(1.0f, static_cast<float>(offset)) * out;
}

}  // namespace

Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit) {
  const Object& object = scene.objects[hit.object];
  Surface surface;
  const Vec3d way = hit.t * Vec3d(ray.direction);
  surface.point = Vec3d(ray.origin) + way;
  surface.normal = front_normal(scene, object, surface.point);
  surface.from_behind = glm::dot(surface.normal, Vec3d(ray.direction)) > 0.0;
  if (surface.from_behind) surface.normal = -surface.normal;
  surface.material = &scene.materials[object.material];

  // The point is computed in double: it is off by roundings of 2^-53, and by what the vertices of
  // a face, rounded to float, are off their common plane.
  surface.error = static_cast<double>(unit_roundoff) * magnitudes(surface.point) +
                  0x1p-50 * (magnitudes(Vec3d(ray.origin)) + magnitudes(way)) +
                  Vec3d(thickness_of(scene, object));

  surface.shading_normal = surface.normal;
  const bool is_face = object.kind == ObjectKind::triangle || object.kind == ObjectKind::polygon;
  if (is_face && scene.faces[object.shape].first_normal != no_index) {
    const Vec3d smooth = patch_normal(scene, scene.faces[object.shape], ray, surface.point);
    const double length = glm::length(smooth);
    if (length > 0.0) {
      const double sign = glm::dot(smooth, surface.normal) < 0.0 ? -1.0 : 1.0;
      surface.shading_normal = (sign / length) * smooth;
    }
  }
  return surface;
}

Vec3 leaving_origin(const Surface& surface, Vec3d direction) {
  const double reach = glm::dot(magnitudes(surface.normal), surface.error);
  const double side = glm::dot(direction, surface.normal) < 0.0 ? -1.0 : 1.0;
  const Vec3d offset = (side * reach) * surface.normal;
  const Vec3d moved = surface.point + offset;
  return {moved_out(moved.x, offset.x), moved_out(moved.y, offset.y), moved_out(moved.z, offset.z)};
}

}  // namespace bspview
