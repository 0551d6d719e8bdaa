#include "core/render/test_cost.h"

#include <numeric>

namespace bspview {

std::array<double, object_kind_count> surface_shares(const Scene& scene,
                                                     std::span<const Aabb> boxes) {
  std::array<double, object_kind_count> shares{};
  for (std::size_t id = 0; id < boxes.size(); ++id) {
    if (boxes[id].empty()) continue;
    shares[static_cast<std::size_t>(scene.objects[id].kind)] += half_area(boxes[id]);
  }
  const double whole = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(whole > 0.0)) return {1.0};  // nothing, points and lines along an axis
  for (double& share : shares) share /= whole;
  return shares;
}

float mean_test_cost(const Scene& scene, std::span<const Aabb> boxes) {
  const auto shares = surface_shares(scene, boxes);
  return static_cast<float>(
      std::inner_product(shares.begin(), shares.end(), test_costs.begin(), 0.0));
}

}  // namespace bspview
