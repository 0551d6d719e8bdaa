#pragma once

#include <vector>

#include "core/base/machine.h"
#include "core/eval/bench/measure.h"

namespace bspview {

struct BenchReport {
  BenchParams params;
  std::vector<Peer> peers;            ///< the first is the default
  std::vector<SceneTimes> triangles;  ///< every scene, cut into triangles
  std::vector<SceneTimes> shapes;     ///< scenes of mostly round shapes, as they are
  Machine machine = this_machine();
};

/// Measures ours and Embree on every scene in triangles, and on those of mostly round shapes as
/// they are. watch.progress adds up to 1. Fails as measure_scene does, and when a scene has none
/// of the kinds of rays.
Result<BenchReport> run_bench(std::span<const Scene> scenes, const BenchParams& params,
                              const Watch& watch = {});

/// `segments`, or the least number where that would make more than a million triangles.
int bench_segments(const Scene& scene, int segments);

}  // namespace bspview
