#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace bspview {

/// Triangles that fill a planar polygon, concave ones too, as indices into its vertices and in its
/// sense of rotation. No edge passes through another vertex, so that meshes stay closed.
/// Triangles without area are left out; nothing is left of a polygon without area. A polygon that
/// crosses itself is covered somehow. O(n^2) where ears are soon found, else O(n^3).
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(std::span<const Vec3> vertices);

/// Round shapes become polyhedra whose vertices lie on them: `segments` (even, at least 4) around
/// the axis, and half as many from pole to pole of a sphere.
inline constexpr int least_segments = 4;

/// The scene in triangles only, seen from the same sides: lights, materials and camera stay,
/// normals of patches and degenerate objects go.
Scene triangulate(const Scene& scene, int segments);

/// How many triangles that makes, at most.
std::size_t count_triangles(const Scene& scene, int segments);

}  // namespace bspview
