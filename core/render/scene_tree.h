#pragma once

#include <stop_token>

#include "core/bsp/build.h"
#include "core/scene/scene.h"

namespace bspview {

/// What a builder needs to know of `scene`: boxes, clipping of polygons in double, and what tests
/// cost.
class SceneBuildInput {
 public:
  explicit SceneBuildInput(const Scene& scene);
  BuildInput input() const;

 private:
  const Scene& scene_;
  std::vector<Aabb> boxes_;
  float cost_intersection_;
};

/// build_tree over all objects of `scene`.
Result<Tree> build_scene_tree(const Scene& scene, const BuildParams& params,
                              std::stop_token stop = {});

}  // namespace bspview
