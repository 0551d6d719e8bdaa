#pragma once

#include <array>

#include "core/scene/scene.h"

namespace bspview {

/// C_I, the cost of testing an object, by ObjectKind; of a polygon, what each corner adds.
using TestCosts = std::array<float, 4>;

/// Where C_T is 1, rays go through trees that are built with these as fast as through any, but for
/// few percent, as `bspeval tune` measures. Triangles are tested eight at a time.
inline constexpr TestCosts default_test_costs{0.04f, 2.0f, 0.5f, 2.0f};

inline float test_cost(const TestCosts& costs, ObjectKind kind) {
  return costs[static_cast<std::size_t>(kind)];
}

/// Of an object, with all its corners.
inline float test_cost(const TestCosts& costs, const Scene& scene, const Object& object) {
  const float cost = test_cost(costs, object.kind);
  if (object.kind != ObjectKind::polygon) return cost;
  return cost * static_cast<float>(scene.faces[object.shape].vertex_count);
}

/// The mean over the objects of a scene, by their numbers.
float mean_test_cost(const TestCosts& costs, const Scene& scene);

}  // namespace bspview
