#pragma once

#include <cstdint>
#include <vector>

namespace bspview {

/// How a traversal went on from a node.
enum class StepKind : std::uint8_t { near_only, far_only, both, leaf };

/// One visited node.
struct RayStep {
  std::uint32_t node = 0;
  StepKind kind = StepKind::leaf;
  int axis = -1;         ///< inner nodes: 0..2
  float split = 0.0f;    ///< inner nodes: position of the plane
  float t_split = 0.0f;  ///< inner nodes: where the ray meets the plane (NaN, inf: never)
  float t_enter = 0.0f;  ///< the ray's interval in the node's cell
  float t_exit = 0.0f;
  std::uint32_t first_test = 0;  ///< leaves: index into RayLog::tests
  std::uint32_t test_count = 0;
};

/// One object tested against the ray.
struct ObjectTest {
  std::uint32_t object = 0;
  bool hit = false;  ///< closer than everything before
  double t = 0.0;    ///< of the hit
};

/// Everything one ray did in the tree, in order.
struct RayLog {
  std::vector<RayStep> steps;
  std::vector<ObjectTest> tests;
};

}  // namespace bspview
