#pragma once

#include <string>
#include <vector>

#include "core/base/machine.h"
#include "core/eval/bench/measure.h"

namespace bspview {

struct ScaleParams {
  BenchParams bench;            ///< of every scene; its rays are fewer than those of the benchmark
  double max_objects = 1e6;     ///< of the largest scenes
  double thread_objects = 1e5;  ///< of the largest scene that threads are tried on
};

/// One standard scene in growing sizes.
struct ScaleFamily {
  std::string name;
  std::vector<SceneTimes> sizes;  ///< as they are, the smallest first
};

/// Rays a second of all threads together, by wall-clock time.
struct ThreadTimes {
  int threads = 1;
  BenchKind kind = BenchKind::primary;
  std::vector<std::vector<double>> rays_a_second;  ///< by peer and repeat
};

struct ScaleReport {
  ScaleParams params;
  std::vector<Peer> peers;  ///< our robust ones, and foreign robust ones that take one ray
  std::vector<ScaleFamily> families;
  std::string thread_scene;
  std::vector<ThreadTimes> threads;  ///< 1, 2, ... every core
  Machine machine = this_machine();
};

/// Measures standard scenes from about a thousand objects up, and threads from one to all.
/// watch.progress adds up to 1. Fails when a stop is requested or a tree cannot be built.
Result<ScaleReport> run_scale(const ScaleParams& params, const Watch& watch = {});

/// Size factors of a standard scene from `least` to `most` objects, each with at least three times
/// as many as the one before.
std::vector<int> scale_sizes(std::string_view name, double least, double most);

/// 1, 2, 4 ... and `most` threads (0: every core).
std::vector<int> thread_steps(int most = 0);

/// ns = at_one + a_doubling * log2(objects), by least squares.
struct LogFit {
  double at_one = 0.0, a_doubling = 0.0;
  double r2 = 0.0;  ///< share of the variance that it explains
};
LogFit fit_log(std::span<const std::pair<double, double>> objects_and_ns);

/// The fit of one peer on one family; nothing for fewer than three sizes.
std::optional<LogFit> fit_of(const ScaleFamily& family, BenchKind kind, std::size_t peer);

/// Tables for the terminal; everything as one object; one line a scene, kind and peer; lines of the
/// time over the logarithm of the objects, a picture that needs nothing else.
std::string to_text(const ScaleReport& report);
std::string to_json(const ScaleReport& report);
std::string to_csv(const ScaleReport& report);
std::string to_svg(const ScaleReport& report);

}  // namespace bspview
