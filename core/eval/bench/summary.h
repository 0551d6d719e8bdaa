#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/eval/bench/run.h"
#include "core/eval/lambda.h"

namespace bspview {

/// Index of the peer that all are compared with: the first foreign one that is robust and takes one
/// ray at a time; without it the default.
std::size_t baseline(const BenchReport& report);

/// Speed over that of `base`, by repeat; none when one of both did not take part.
Measured speed_ratio(const KindTimes& times, std::size_t peer, std::size_t base);

/// The kind's times on a scene; null: it has no such rays.
const KindTimes* find_kind(const SceneTimes& scene, BenchKind kind);

/// Geometric mean of speed_ratio over the scenes with such rays; nothing when the peer did not take
/// part in one of them.
std::optional<double> mean_ratio(const BenchReport& report, std::span<const SceneTimes> scenes,
                                 BenchKind kind, std::size_t peer);

/// A thing aimed at, and how far off it is.
struct Goal {
  std::string name;      ///< what is compared, for people
  std::string key;       ///< in files
  std::string own;       ///< our robust peer that comes nearest
  double ratio = 0.0;    ///< its speed over that of the fastest rival of each scene: geometric mean
  double wanted = 1.0;   ///< what the ratio ought to be
  bool stretch = false;  ///< more than has to be
  std::string worst;     ///< the scene where we are furthest behind
  double worst_ratio = 0.0;
};

/// Those that rays and rivals were measured for.
std::vector<Goal> goals(const BenchReport& report);

}  // namespace bspview
