// Ear clipping after Meisters 1975, "Polygons Have Ears", with every turn decided exactly.

#include "core/scene/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/check.h"
#include "core/math/exact.h"

namespace bspview {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The polygon seen along the axis nearest to its normal, while ears are cut off.
class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec3> vertices)
      : vertices_(vertices), left_(vertices.size()) {
    std::iota(left_.begin(), left_.end(), 0u);
    const Vec3d normal = polygon_plane(vertices).normal;
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    }
    axis_[axis] = 1.0f;
    sense_ = normal[axis] > 0.0 ? 1 : -1;
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (left_.size() >= 3) {
      const std::size_t ear = find_ear();
      if (turn(ear) != 0) triangles.push_back(corner(ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
      next_ = ear;
    }
    return triangles;
  }

 private:
  std::array<std::uint32_t, 3> corner(std::size_t i) const {
    const std::size_t count = left_.size();
    return {left_[(i + count - 1) % count], left_[i], left_[(i + 1) % count]};
  }

  /// 1: a, b, c turn in the polygon's sense, -1: against it, 0: they lie on a line.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return sense_ * side_of_edge(vertices_[a], axis_, vertices_[b], vertices_[c]);
  }
  int turn(std::size_t i) const {
    const auto [a, b, c] = corner(i);
    return turn(a, b, c);
  }

  /// Whether no vertex but those in its corners lies in the triangle or on its rim.
  bool is_free(const std::array<std::uint32_t, 3>& triangle) const {
    const auto [a, b, c] = triangle;
    return std::ranges::none_of(left_, [&](std::uint32_t i) {
      const Vec3 p = vertices_[i];
      if (p == vertices_[a] || p == vertices_[b] || p == vertices_[c]) return false;
      return turn(a, b, i) >= 0 && turn(b, c, i) >= 0 && turn(c, a, i) >= 0;
    });
  }

  /// The next ear; where there is none, since the polygon touches or crosses itself, a corner
  /// without area, else the first that is convex, else any.
  std::size_t find_ear() const {
    std::size_t straight = left_.size(), convex = left_.size();
    for (std::size_t k = 0; k < left_.size(); ++k) {
      const std::size_t i = (next_ + k) % left_.size();
      const int side = turn(i);
      if (side > 0 && is_free(corner(i))) return i;
      if (side == 0) straight = std::min(straight, i);
      if (side > 0) convex = std::min(convex, i);
    }
    if (straight < left_.size()) return straight;
    return convex < left_.size() ? convex : 0;
  }

  std::span<const Vec3> vertices_;
  std::vector<std::uint32_t> left_;  // vertices that are not cut off yet
  Vec3 axis_{0.0f};
  int sense_ = 1;
  std::size_t next_ = 0;  // where the next ear is looked for: triangles come out less thin
};

/// Adds triangles of one material; those without area are left out.
class MeshWriter {
 public:
  explicit MeshWriter(Scene& scene) : scene_(scene) {}

  void start(std::uint32_t material, bool inside_out) {
    material_ = material;
    inside_out_ = inside_out;
  }
  void add(Vec3 a, Vec3 b, Vec3 c) {
    if (a == b || b == c || c == a) return;
    if (inside_out_) std::swap(b, c);
    add_face(scene_, material_, std::array{a, b, c});
  }
  /// Two triangles between the edges a0 a1 and b0 b1.
  void add_quad(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1) {
    add(a0, a1, b1);
    add(a0, b1, b0);
  }

 private:
  Scene& scene_;
  std::uint32_t material_ = 0;
  bool inside_out_ = false;
};

/// Points on a circle, counter-clockwise when seen against the direction of u x v.
std::vector<Vec3> circle(Vec3d centre, Vec3d u, Vec3d v, int segments) {
  std::vector<Vec3> points;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * pi * i / segments;
    points.push_back(Vec3(centre + std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

/// The band between two circles, seen from outside when the second is the upper one.
void add_band(MeshWriter& mesh, std::span<const Vec3> lower, std::span<const Vec3> upper) {
  const std::size_t count = lower.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    mesh.add_quad(lower[i], lower[next], upper[i], upper[next]);
  }
}

void add_sphere_mesh(MeshWriter& mesh, const Sphere& sphere, int segments) {
  const Vec3d centre(sphere.centre);
  const double radius = std::abs(static_cast<double>(sphere.radius));
  const int bands = segments / 2;
  const auto ring = [&](int i) {
    const double angle = pi * i / bands;
    const bool pole = i == 0 || i == bands;  // exactly one point there
    const double around = pole ? 0.0 : radius * std::sin(angle);
    return circle(centre - Vec3d(0.0, 0.0, radius * std::cos(angle)), Vec3d(around, 0.0, 0.0),
                  Vec3d(0.0, around, 0.0), segments);
  };
  std::vector<Vec3> lower = ring(0);
  for (int i = 1; i <= bands; ++i) {
    std::vector<Vec3> upper = ring(i);
    add_band(mesh, lower, upper);
    lower = std::move(upper);
  }
}

void add_cone_mesh(MeshWriter& mesh, const Cone& cone, int segments) {
  const Vec3d axis = glm::normalize(Vec3d(cone.apex) - Vec3d(cone.base));
  const Vec3d other = std::abs(axis.x) < 0.5 ? Vec3d(1.0, 0.0, 0.0) : Vec3d(0.0, 1.0, 0.0);
  const Vec3d u = glm::normalize(glm::cross(other, axis)), v = glm::cross(axis, u);
  const auto ring = [&](Vec3 centre, float signed_radius) {
    const double radius = std::abs(static_cast<double>(signed_radius));
    return circle(Vec3d(centre), radius * u, radius * v, segments);
  };
  add_band(mesh, ring(cone.base, cone.base_radius), ring(cone.apex, cone.apex_radius));
}

std::size_t count_triangles(const Scene& scene, const Object& object, int segments) {
  const auto around = static_cast<std::size_t>(segments);
  switch (object.kind) {
    case ObjectKind::triangle:
    case ObjectKind::polygon:
      return scene.faces[object.shape].vertex_count - 2u;
    case ObjectKind::sphere:
      return around * (around - 2u);
    case ObjectKind::cone:
      return 2u * around;
  }
  return 0;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(std::span<const Vec3> vertices) {
  return EarClipper(vertices).run();
}

Scene triangulate(const Scene& scene, int segments) {
  BSPVIEW_CHECK(segments >= least_segments && segments % 2 == 0);
  Scene mesh = scene;
  mesh.objects.clear();
  mesh.faces.clear();
  mesh.spheres.clear();
  mesh.cones.clear();
  mesh.cone_frames.clear();
  mesh.vertices.clear();
  mesh.normals.clear();
  mesh.planes.clear();
  MeshWriter writer(mesh);
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    if (is_degenerate(scene, id)) continue;
    const Object& object = scene.objects[id];
    writer.start(object.material, false);
    if (object.kind == ObjectKind::sphere) {
      const Sphere& sphere = scene.spheres[object.shape];
      writer.start(object.material, sphere.radius < 0.0f);
      add_sphere_mesh(writer, sphere, segments);
    } else if (object.kind == ObjectKind::cone) {
      const Cone& cone = scene.cones[object.shape];
      writer.start(object.material, cone.base_radius < 0.0f || cone.apex_radius < 0.0f);
      add_cone_mesh(writer, cone, segments);
    } else {
      const auto vertices = vertices_of(scene, scene.faces[object.shape]);
      for (const auto& [a, b, c] : triangulate_polygon(vertices)) {
        writer.add(vertices[a], vertices[b], vertices[c]);
      }
    }
  }
  return mesh;
}

std::size_t count_triangles(const Scene& scene, int segments) {
  std::size_t count = 0;
  for (const Object& object : scene.objects) count += count_triangles(scene, object, segments);
  return count;
}

}  // namespace bspview
