#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace bspview {
namespace {

/// False for NaN, too.
bool in_range(float x) {
  return std::abs(x) <= max_coordinate;
}

bool in_range(Vec3 p) {
  return in_range(p.x) && in_range(p.y) && in_range(p.z);
}

bool in_range(std::span<const Vec3> vertices) {
  return std::ranges::all_of(vertices, [](Vec3 vertex) { return in_range(vertex); });
}

bool in_range(const Sphere& sphere) {
  return in_range(sphere.centre) && in_range(sphere.radius);
}

bool in_range(const Cone& cone) {
  return in_range(cone.base) && in_range(cone.base_radius) && in_range(cone.apex) &&
         in_range(cone.apex_radius);
}

/// An object of the shape that was added last.
void add_object(Scene& scene, ObjectKind kind, std::size_t shape_count, std::uint32_t material) {
  BSPVIEW_CHECK(shape_count < no_index && scene.objects.size() < no_index);
  scene.objects.push_back({kind, static_cast<std::uint32_t>(shape_count - 1), material});
}

Aabb bounds(std::span<const Vec3> vertices) {
  Aabb box;
  if (!in_range(vertices)) return box;
  for (const Vec3 vertex : vertices) box.grow(vertex);
  return box;
}

Aabb bounds(const Sphere& sphere) {
  return in_range(sphere) ? sphere_bounds(sphere) : Aabb{};
}

Aabb bounds(const Cone& cone) {
  return in_range(cone) ? cone_bounds(cone) : Aabb{};
}

bool is_degenerate(std::span<const Vec3> vertices) {
  if (vertices.size() < 3 || !in_range(vertices)) return true;
  // Twice the area vector, from the first vertex: small errors far from the origin.
  const Vec3d origin(vertices[0]);
  Vec3d area(0.0);
  for (std::size_t i = 2; i < vertices.size(); ++i)
    area += glm::cross(Vec3d(vertices[i - 1]) - origin, Vec3d(vertices[i]) - origin);
  return area == Vec3d(0.0);
}

bool is_degenerate(const Sphere& sphere) {
  return !in_range(sphere) || sphere.radius == 0.0f;
}

bool is_degenerate(const Cone& cone) {
  if (!in_range(cone)) return true;
  const bool no_radius = cone.base_radius == 0.0f && cone.apex_radius == 0.0f;
  const bool crossed = (cone.base_radius < 0.0f && cone.apex_radius > 0.0f) ||
                       (cone.base_radius > 0.0f && cone.apex_radius < 0.0f);
  return no_radius || crossed || cone.base == cone.apex;
}

}  // namespace

std::uint32_t add_material(Scene& scene, const Material& material) {
  // Backwards: an equal one was most likely added a moment ago.
  for (std::size_t i = scene.materials.size(); i-- > 0;)
    if (scene.materials[i] == material) return static_cast<std::uint32_t>(i);
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

void add_face(Scene& scene, std::uint32_t material, std::span<const Vec3> vertices,
              std::span<const Vec3> normals) {
  BSPVIEW_CHECK(vertices.size() >= 3 && (normals.empty() || normals.size() == vertices.size()));
  BSPVIEW_CHECK(scene.vertices.size() + vertices.size() < no_index);
  Face face;
  face.first_vertex = static_cast<std::uint32_t>(scene.vertices.size());
  face.vertex_count = static_cast<std::uint32_t>(vertices.size());
  if (!normals.empty()) face.first_normal = static_cast<std::uint32_t>(scene.normals.size());
  scene.vertices.insert(scene.vertices.end(), vertices.begin(), vertices.end());
  scene.normals.insert(scene.normals.end(), normals.begin(), normals.end());
  if (vertices.size() > 3) {
    face.plane = static_cast<std::uint32_t>(scene.planes.size());
    scene.planes.push_back(polygon_plane(vertices));
  }
  scene.faces.push_back(face);
  const auto kind = vertices.size() == 3 ? ObjectKind::triangle : ObjectKind::polygon;
  add_object(scene, kind, scene.faces.size(), material);
}

void add_sphere(Scene& scene, std::uint32_t material, const Sphere& sphere) {
  scene.spheres.push_back(sphere);
  add_object(scene, ObjectKind::sphere, scene.spheres.size(), material);
}

void add_cone(Scene& scene, std::uint32_t material, const Cone& cone) {
  scene.cones.push_back(cone);
  scene.cone_frames.emplace_back(cone);
  add_object(scene, ObjectKind::cone, scene.cones.size(), material);
}

ObjectCounts count_objects(const Scene& scene) {
  ObjectCounts counts;
  counts.objects = scene.objects.size();
  counts.spheres = scene.spheres.size();
  counts.cones = scene.cones.size();
  for (const Face& face : scene.faces) {
    if (face.first_normal != no_index) {
      ++counts.patches;
    } else if (face.vertex_count == 3) {
      ++counts.triangles;
    } else {
      ++counts.polygons;
    }
  }
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id)
    counts.degenerate += is_degenerate(scene, id) ? 1 : 0;
  return counts;
}

Aabb object_bounds(const Scene& scene, std::uint32_t object) {
  const auto [kind, shape, material] = scene.objects[object];
  switch (kind) {
    case ObjectKind::triangle:
    case ObjectKind::polygon:
      return bounds(vertices_of(scene, scene.faces[shape]));
    case ObjectKind::sphere:
      return bounds(scene.spheres[shape]);
    case ObjectKind::cone:
      return bounds(scene.cones[shape]);
  }
  return {};
}

std::vector<Aabb> object_bounds(const Scene& scene) {
  std::vector<Aabb> boxes;
  boxes.reserve(scene.objects.size());
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) boxes.push_back(object_bounds(scene, i));
  return boxes;
}

Aabb scene_bounds(const Scene& scene) {
  Aabb box;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) box.grow(object_bounds(scene, i));
  return box;
}

bool is_degenerate(const Scene& scene, std::uint32_t object) {
  const auto [kind, shape, material] = scene.objects[object];
  switch (kind) {
    case ObjectKind::triangle:
    case ObjectKind::polygon:
      return is_degenerate(vertices_of(scene, scene.faces[shape]));
    case ObjectKind::sphere:
      return is_degenerate(scene.spheres[shape]);
    case ObjectKind::cone:
      return is_degenerate(scene.cones[shape]);
  }
  return true;
}

}  // namespace bspview
