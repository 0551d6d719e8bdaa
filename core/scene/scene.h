#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/math/aabb.h"
#include "core/scene/camera.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/shape/cone.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"

namespace bspview {

enum class ObjectKind : std::uint8_t { triangle, polygon, sphere, cone };

inline constexpr std::uint32_t no_index = 0xffffffffu;

/// Planar polygon, three or more vertices, concave allowed. A polygonal patch has normals, too.
struct Face {
  std::uint32_t first_vertex = 0;  ///< index into Scene::vertices
  std::uint32_t vertex_count = 0;
  std::uint32_t first_normal = no_index;  ///< index into Scene::normals: one a vertex
  std::uint32_t plane = no_index;         ///< index into Scene::planes; polygons only
  bool operator==(const Face&) const = default;
};

/// One record of a scene file. Its index in Scene::objects is its id everywhere.
struct Object {
  ObjectKind kind = ObjectKind::triangle;
  std::uint32_t shape = 0;     ///< index into faces (triangle, polygon), spheres or cones
  std::uint32_t material = 0;  ///< index into materials
  bool operator==(const Object&) const = default;
};

/// Everything a scene file says. Build it with the add_ functions, which keep the indices right.
struct Scene {
  std::string name;
  Vec3 background{0.0f};
  Camera camera;
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<Object> objects;  ///< in file order
  std::vector<Face> faces;
  std::vector<Sphere> spheres;
  std::vector<Cone> cones;
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;
  std::vector<PolygonPlane> planes;
  std::vector<ConeFrame> cone_frames;  ///< one a cone
  /// Opaque objects are seen from behind even under the SPD's one-sided rules (teapot).
  bool two_sided = false;

  bool operator==(const Scene&) const = default;
};

/// Index of an equal material that is there already, else of a new one.
std::uint32_t add_material(Scene& scene, const Material& material);

/// Adds one object with material `material`; a face of three vertices becomes a triangle.
/// `normals` is empty or holds one a vertex.
void add_face(Scene& scene, std::uint32_t material, std::span<const Vec3> vertices,
              std::span<const Vec3> normals = {});
void add_sphere(Scene& scene, std::uint32_t material, const Sphere& sphere);
void add_cone(Scene& scene, std::uint32_t material, const Cone& cone);

/// How many objects of each kind; a patch is a triangle or polygon with normals and counts as
/// patch.
struct ObjectCounts {
  std::size_t objects = 0, triangles = 0, polygons = 0, patches = 0, spheres = 0, cones = 0;
  std::size_t degenerate = 0;  ///< of the objects: never hit, see is_degenerate
  bool operator==(const ObjectCounts&) const = default;
};
ObjectCounts count_objects(const Scene& scene);

/// Whether a face is a triangle.
inline bool has_triangles(const Scene& scene) {
  return scene.faces.size() > scene.planes.size();
}

/// Vertices of a face, in order.
inline std::span<const Vec3> vertices_of(const Scene& scene, const Face& face) {
  return std::span(scene.vertices).subspan(face.first_vertex, face.vertex_count);
}

/// Largest magnitude of a coordinate or radius that is traced: squares and areas stay finite.
inline constexpr float max_coordinate = 1e18f;

/// Box of one object, rounded outwards: it holds every point of the object. Empty when a number of
/// the object is NaN or leaves `max_coordinate`.
Aabb object_bounds(const Scene& scene, std::uint32_t object);
std::vector<Aabb> object_bounds(const Scene& scene);

/// Union of all object boxes; empty for a scene without objects.
Aabb scene_bounds(const Scene& scene);

/// Nothing can be traced against such an object (a number that is NaN or beyond `max_coordinate`,
/// no area, no length, radii of opposite signs): it is kept, since ids are record numbers, and is
/// never hit.
bool is_degenerate(const Scene& scene, std::uint32_t object);

}  // namespace bspview
