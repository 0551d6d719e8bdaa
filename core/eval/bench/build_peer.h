#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/bsp/tree.h"
#include "core/scene/scene.h"

namespace bspview {

/// What is known of a tree of ours besides its size.
struct TreeShape {
  int deepest_leaf = 0;
  double expected_cost = 0.0;
  bool memory_limit_reached = false;
};

/// One build and its tree.
struct TimedBuild {
  double seconds = 0.0;  ///< from the scene in memory to the tree, boxes of the objects included
  std::size_t bytes = 0;
  std::optional<TreeShape> shape;
};

/// What takes part in the benchmark of building.
struct BuildPeer {
  std::string name;  ///< short: a key in files
  std::string what;  ///< one line for people
  bool foreign = false;
  std::function<Result<TimedBuild>(const Scene&, int threads, std::stop_token)> build;
};

/// Ours, with `params` but for builder and threads.
std::vector<BuildPeer> own_builders(const BuildParams& params, std::span<const Builder> builders);

/// Embree's trees of boxes, at its medium and its high quality. None where the build found no
/// libembree-dev.
std::vector<BuildPeer> embree_builders();

}  // namespace bspview
