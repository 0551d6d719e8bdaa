#pragma once

#include <vector>

#include "core/eval/stress/dice.h"
#include "core/math/ray.h"
#include "core/scene/scene.h"

namespace bspview::stress {

/// A mesh without a hole, of size 1 or so: from a point inside, every ray hits it.
struct ClosedMesh {
  Scene scene;
  Vec3 centre{0.0f};
  float ring =
      0.0f;  ///< radius of the circle in the xy plane that the inside surrounds; 0: a point

  /// A point well inside.
  Vec3 point_inside(Dice& dice) const;
};

/// A subdivided icosahedron: 20 x 4^levels triangles.
ClosedMesh make_icosphere(int levels, Vec3 centre);
/// 2 x n x n triangles.
ClosedMesh make_torus(int n, Vec3 centre);
/// Axis-aligned, each side n x n squares of two triangles.
ClosedMesh make_cube(int n, Vec3 centre);
/// Circles of latitude and longitude: 2 x columns x (rows - 1) triangles.
ClosedMesh make_globe(int rows, int columns, Vec3 centre);
/// Each of its squares one polygon: not quite planar once the vertices are rounded.
ClosedMesh make_square_globe(int rows, int columns, Vec3 centre);

/// Where rays are aimed.
enum class Aim { anywhere, edge, vertex };
inline constexpr int aim_count = 3;

/// A point of `scene`: of its box, an edge or a vertex; scenes without faces have no edges.
Vec3 aim_at(const Scene& scene, const Aabb& box, Aim aim, Dice& dice);

/// A ray that surely hits the mesh: it starts inside, or outside and passes through the inside.
Ray ray_through(const ClosedMesh& mesh, Aim aim, Dice& dice);

}  // namespace bspview::stress
