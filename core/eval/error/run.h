#pragma once

#include <string>
#include <vector>

#include "core/base/machine.h"
#include "core/eval/error/config.h"
#include "core/eval/error/counts.h"
#include "core/scene/scene.h"

namespace bspview {

struct ErrorParams {
  BuildParams build;  ///< of the default; its threads build and judge
  Traversal traversal = Traversal::robust;
  std::size_t rays = 40000;  ///< of a group and scene
  int repeats = 9;
  int timing_threads = 1;  ///< 1: processor time of the thread; more: wall-clock time
  std::uint64_t seed = 0;
};

/// What was measured on one scene. Vectors have an element a configuration.
struct SceneErrors {
  std::string name;
  ObjectCounts objects;
  bool only_triangles = false;
  std::array<std::uint64_t, ray_group_count> rays{};
  std::vector<ErrorCounts> counts;
  /// Seconds by group and repeat. Aimed rays are not timed.
  std::vector<std::array<std::vector<double>, ray_group_count>> seconds;
  std::vector<char> measured;  ///< 0: a foreign kernel, which this scene is not for
};

struct ErrorReport {
  ErrorParams params;
  std::vector<ErrorConfig> configs;  ///< [0]: the fast anchor, [1]: the default
  std::size_t pictures_config = 0;   ///< the default tests in wide nodes, as pictures are traced
  std::vector<Factor> strongest_factors;  ///< the three whose combinations were measured
  std::vector<SceneErrors> scenes;
  Machine machine = this_machine();
};
inline constexpr std::size_t fast_config = 0, default_config = 1;

/// Records rays, judges one factor at a time, finds the three strongest factors, judges their
/// combinations, then times everything, repeat after repeat over all configurations.
/// watch.progress adds up to 1. Fails when a stop is requested or a tree cannot be built.
Result<ErrorReport> measure_errors(std::span<const Scene> scenes, const ErrorParams& params,
                                   const Watch& watch = {});

}  // namespace bspview
