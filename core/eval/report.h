#pragma once

#include <optional>
#include <string>

#include "core/base/machine.h"
#include "core/bsp/stats.h"
#include "core/eval/delta.h"
#include "core/eval/lambda.h"

namespace bspview {

/// The tree as it was built, and how.
struct TreeReport {
  TreeReport(const Tree& tree, Traversal traversal);

  BuildParams params;  ///< with depth, clipping and threads as they were in force
  Traversal traversal;
  bool memory_limit_reached;
  std::size_t bytes;
  TreeStats stats;
  std::uint64_t unbuilt_leaves = 0, unbuilt_references = 0;  ///< of stats: no ray has needed them
};

/// What a command found out. What is nullopt was not asked for.
struct Report {
  explicit Report(const Scene& scene);

  std::string scene_name;
  ObjectCounts objects;
  Aabb bounds;  ///< of the objects
  std::optional<TreeReport> tree;
  std::optional<Delta> delta;
  std::optional<Lambda> lambda;
  std::optional<RayCounts> rays;
  std::optional<double> samples_per_pixel;  ///< eye rays / pixels
  /// From the scene to the first picture; of trees that grow while it is made.
  std::optional<double> first_picture_seconds;
  std::uint64_t seed = 0;
  Machine machine = this_machine();
};

/// One JSON object, a line for each of its sections; null for what is not defined and for what was
/// not asked for.
std::string to_json(const Report& report);

/// Aligned tables of what was asked for; a dash for what is not defined.
std::string to_text(const Report& report);

}  // namespace bspview
