#pragma once

#include <cstdint>

namespace bspview {

enum class RayKind : std::uint8_t { primary, reflected, refracted, shadow };

/// Integer counts of a set of rays; sums do not depend on the order.
struct RayCounts {
  std::uint64_t primary = 0, reflected = 0, refracted = 0, shadow = 0;
  std::uint64_t primary_hits = 0, secondary_hits = 0, shadow_hits = 0;
  std::uint64_t tests = 0;                        ///< one object against one ray
  std::uint64_t nodes_inner = 0, nodes_leaf = 0;  ///< visits

  bool operator==(const RayCounts&) const = default;
  RayCounts& operator+=(const RayCounts& other);

  /// Counts one ray of `kind`, and whether it hit something.
  void add_ray(RayKind kind, bool hit);

  std::uint64_t secondary() const { return reflected + refracted; }
  std::uint64_t all() const { return primary + secondary() + shadow; }
  /// Rays of every kind that hit something (Havran: "IntersRequired").
  std::uint64_t minimal_tests() const { return primary_hits + secondary_hits + shadow_hits; }
};

}  // namespace bspview
