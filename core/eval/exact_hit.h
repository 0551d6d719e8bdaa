#pragma once

#include <cstdint>

#include "core/render/intersect.h"

namespace bspview {

/// How a ray meets an object, decided beyond rounding.
enum class Meeting {
  miss,
  interior,   ///< surely hit, away from every border
  border,     ///< exactly through an edge, a vertex
  undecided,  ///< quadrics: within 2 ulp of double of a tangent or a rim
};

/// The nearest meeting of one ray and one object inside the ray's interval.
struct ExactHit {
  Meeting meeting = Meeting::miss;
  double t = no_hit;  ///< in units of the ray's direction, rounded to nearest; no_hit for a miss
  bool operator==(const ExactHit&) const = default;
};

/// Triangles and the outlines of polygons: double where its error bound decides, then float128,
/// then rational numbers. Planes of polygons (PolygonPlane, as stored in the scene), spheres and
/// cones: float128. Shares no code with the tests that pictures use. A degenerate object, and a
/// ray that is none (a direction of 0, NaN or infinity), meet nothing.
ExactHit exact_hit(const Scene& scene, std::uint32_t object, const Ray& ray, Sides sides);

}  // namespace bspview
