#pragma once

#include <span>
#include <vector>

#include "core/base/watch.h"
#include "core/eval/error/config.h"
#include "core/eval/error/counts.h"

namespace bspview {

/// Right answers of one scene, and what the rays of a measurement are.
struct JudgedScene {
  World world;  ///< with any tree
  const Reference& reference;
  std::span<const RayBatch> batches;
  int threads = 0;  ///< 0: every core; changes no count
};

/// A configuration as it answers rays of one scene; callable from several threads.
struct BoundKernel {
  BoundKernel() = default;
  BoundKernel(const ErrorConfig& config, const World& world);

  Kernel::Closest closest;  ///< null: not for this scene, nothing is judged
  Kernel::Occluded occluded;
  std::optional<OffsetRule> offset;  ///< nothing: foreign, only its hits are judged
};

/// Whether losing the nearest hit of a ray is a leak: it comes through a surface of triangles. Else
/// it only cuts a rim: within a thousandth of the nearest triangle's size it passes surfaces an
/// even number of times, or one from the front and one from behind, and there is no hole.
bool leaks_at(const JudgedScene& scene, const Ray& ray);

/// Judges the answers of every kernel to every ray; one result a kernel. Equal answers are judged
/// once. What a stop leaves is worthless.
std::vector<ErrorCounts> judge_hits(const JudgedScene& scene, std::span<const BoundKernel> kernels,
                                    const Watch& watch = {});

}  // namespace bspview
