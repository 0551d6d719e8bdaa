#pragma once

#include <vector>

#include "core/render/intersect.h"

namespace bspview::stress {

/// The nearest hit by testing every object whose box, widened far beyond any rounding, the ray
/// meets: independent of trees and traversals. The scene outlives it.
class BruteForce {
 public:
  explicit BruteForce(const Scene& scene);

  /// As closest_hit, but for the leaf.
  Hit closest(const Ray& ray) const;
  const Aabb& bounds() const { return bounds_; }  ///< of everything that can be hit

 private:
  struct Group {
    Aabb box;
    std::uint32_t first, count;  // objects; count == 0: children at index + 1 and `first`
  };
  void group(std::uint32_t first, std::uint32_t count, const std::vector<Aabb>& boxes);

  const Scene& scene_;
  Aabb bounds_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> objects_;
};

}  // namespace bspview::stress
