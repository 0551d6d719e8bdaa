#include "core/render/test_cost.h"

namespace bspview {

float mean_test_cost(const TestCosts& costs, const Scene& scene) {
  if (scene.objects.empty()) return costs.front();
  // Objects have shapes of their own, and polygons planes. Millions need not be looked at.
  const std::size_t triangles = scene.faces.size() - scene.planes.size();
  const std::size_t corners = scene.vertices.size() - 3 * triangles;  // of polygons
  const auto sum = [&](ObjectKind kind, std::size_t count) {
    return double{test_cost(costs, kind)} * static_cast<double>(count);
  };
  const double all = sum(ObjectKind::triangle, triangles) + sum(ObjectKind::polygon, corners) +
                     sum(ObjectKind::sphere, scene.spheres.size()) +
                     sum(ObjectKind::cone, scene.cones.size());
  return static_cast<float>(all / static_cast<double>(scene.objects.size()));
}

}  // namespace bspview
