#pragma once

#include "core/base/raw_vector.h"
#include "core/bsp/build.h"
#include "core/render/test_cost.h"
#include "core/scene/scene.h"

namespace bspview {

/// What a builder needs to know of `scene`: boxes, clipping of polygons in double, and what tests
/// cost. Made by the threads of the enclosing with_threads. After a stop, boxes are missing, and no
/// builder with the same token looks at them.
class SceneBuildInput {
 public:
  explicit SceneBuildInput(const Scene& scene, const TestCosts& test_costs = default_test_costs,
                           const std::stop_token& stop = {});
  BuildInput input() const;

 private:
  const Scene& scene_;
  const TestCosts test_costs_;
  const float mean_test_cost_;
  RawVector<Aabb> boxes_;
};

/// build_tree over all objects of `scene`.
Result<Tree> build_scene_tree(const Scene& scene, const BuildParams& params,
                              const Watch& watch = {},
                              const TestCosts& test_costs = default_test_costs);

}  // namespace bspview
