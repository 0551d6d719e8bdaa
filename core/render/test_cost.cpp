#include "core/render/test_cost.h"

namespace bspview {

float mean_test_cost(const TestCosts& costs, const Scene& scene) {
  if (scene.objects.empty()) return costs.front();
  double sum = 0.0;
  for (const Object& object : scene.objects) sum += test_cost(costs, scene, object);
  return static_cast<float>(sum / static_cast<double>(scene.objects.size()));
}

}  // namespace bspview
