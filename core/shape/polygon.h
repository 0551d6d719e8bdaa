#pragma once

#include <span>

#include "core/math/aabb.h"
#include "core/shape/ray_query.h"

namespace bspview {

/// Plane of a polygon: Newell's normal (not normalised) through the mean of the vertices, so that
/// vertices rounded off the plane do not favour one corner.
struct PolygonPlane {
  Vec3d point, normal;
  int x_axis = 0, y_axis = 1;  ///< on which the polygon is widest
  double area = 0.0;           ///< sum of the magnitudes of the normal's components
  double thickness = 0.0;      ///< bound on |normal . (vertex - point)|: vertices are off the plane
  bool operator==(const PolygonPlane&) const = default;
};

/// Relative to t.
inline constexpr double longest_passage = 0x1p-20;

PolygonPlane polygon_plane(std::span<const Vec3> vertices);

/// Planar polygon, concave or self-overlapping (even-odd), decided exactly for the vertices as they
/// are. A ray through a shared edge hits exactly one of the two polygons: their meshes have neither
/// gaps nor double hits. Where the vertices are off the plane, the ray meets the polygon somewhere
/// on its passage through the layer that holds them: t is that of the plane, and the end of the
/// passage where that is longer than longest_passage (a face at coordinates of 1e5, whose vertices
/// are rounded by 1 % of its size, or a ray along it). So t is never before the first cell of a
/// tree that the ray shares with a part of the polygon.
double hit_polygon(const RayQuery& ray, std::span<const Vec3> vertices, const PolygonPlane& plane,
                   Sides sides);

/// Box of the part of a polygon (or triangle) inside `cell`, rounded outwards; empty when nothing
/// is inside. Clipped in double with a margin, so that rounding only ever keeps too much.
Aabb clip_polygon(std::span<const Vec3> vertices, const Aabb& cell);

/// The same where the box of the whole polygon is known.
Aabb clip_polygon(std::span<const Vec3> vertices, const Aabb& whole, const Aabb& cell);

/// Mean value coordinates (Floater 2003) of `point` (in the polygon's plane): weights of the
/// vertices, adding up to 1; written to `weights`, one a vertex.
void mean_value_coordinates(std::span<const Vec3> vertices, Vec3 point, std::span<float> weights);

}  // namespace bspview
