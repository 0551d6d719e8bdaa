#pragma once

#include <array>
#include <cstdint>

#include "core/render/intersect.h"

namespace bspview {

/// How a ray meets an object, decided beyond rounding.
enum class Meeting {
  miss,
  interior,   ///< surely hit, away from every border
  border,     ///< exactly through an edge or a vertex
  undecided,  ///< quadrics: within 2 ulp of float of a tangent or a rim; a t that rounds to the end
              ///< of the ray's interval
};

struct ExactHit {
  Meeting meeting = Meeting::miss;
  double t = no_hit;  ///< in units of the ray's direction, rounded to nearest; no_hit for a miss
  bool operator==(const ExactHit&) const = default;
};

/// The meetings of one ray and one object inside the ray's interval, nearest first, up to the first
/// that is sure: a second one follows only where the first can be doubted. Unused ones are misses.
using ExactHits = std::array<ExactHit, 2>;

/// Triangles and outlines of polygons: double where its error bound decides, then float128, then
/// exact arithmetic. Planes of polygons (Scene::planes, as stored), spheres and cones: float128.
/// Shares no code with the tests that pictures use. A degenerate object, and a ray that is none (a
/// direction of 0, NaN or infinity), meet nothing.
ExactHits exact_hits(const Scene& scene, std::uint32_t object, const Ray& ray, Sides sides);

}  // namespace bspview
