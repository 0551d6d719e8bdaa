#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/machine.h"
#include "core/base/watch.h"
#include "core/eval/bench/build_peer.h"
#include "core/eval/bench/scale.h"
#include "core/eval/bench/trees.h"
#include "core/eval/lambda.h"

namespace bspview {

struct BuildBenchParams {
  BuildParams build;              ///< but for its builder; its threads are the most that are tried
  std::vector<Builder> builders;  ///< of ours; none: every one whose name begins with "sah"
  std::vector<double> sizes{1e3, 1e4, 1e5, 1e6};  ///< objects of the scenes, about
  int repeats = 9;                                ///< at most
  double patience = 3.0;      ///< seconds, after which a scene is not repeated any more
  std::vector<Scene> scenes;  ///< those that rays go through, in trees of every builder of ours
  std::size_t rays = 65536;   ///< about as many of every kind
};

/// What one peer took for one scene with so many threads.
struct BuildTimes {
  std::size_t peer = 0;
  int threads = 1;
  std::vector<double> seconds;  ///< by repeat
  std::size_t bytes = 0;
  std::optional<TreeShape> shape;
};

struct BuiltScene {
  std::string name;
  std::size_t objects = 0;
  std::vector<BuildTimes> times;  ///< of every peer with every number of threads
};

/// One standard scene in growing sizes.
struct BuildFamily {
  std::string name;
  std::vector<BuiltScene> sizes;  ///< the smallest first
};

struct BuildReport {
  BuildBenchParams params;
  std::vector<BuildPeer> peers;  ///< ours first
  std::vector<int> threads;      ///< 1, 2, 4 ... all
  std::vector<BuildFamily> families;
  std::vector<TreeComparison> quality;  ///< of the scenes; trees in the order of the peers
  Machine machine = this_machine();
};

/// Builds trees of mount, tetra, balls and gears, repeat after repeat over all peers and numbers of
/// threads. watch.progress adds up to 1. Fails when a stop is requested or a tree cannot be built.
Result<BuildReport> run_build_bench(const BuildBenchParams& params, const Watch& watch = {});

/// Size factors of a standard scene that come nearest to the wanted numbers of objects, in ratio:
/// ascending, each once, none that is off by more than a factor of three.
std::vector<int> nearest_sizes(std::string_view name, std::span<const double> objects);

/// seconds ~ (N log N)^exponent, by least squares of the logarithms.
struct PowerFit {
  double exponent = 0.0;
  double r2 = 0.0;  ///< share of the variance that it explains
};

/// The fit of one peer on one family; nothing for fewer than three sizes.
std::optional<PowerFit> fit_of(const BuildFamily& family, std::size_t peer, int threads);

/// The times of a peer; null: it did not take part.
const BuildTimes* find_times(const BuiltScene& scene, std::size_t peer, int threads);

/// Tables for the terminal; everything as one object; one line a scene, peer and number of threads;
/// lines of the time an object over the objects, a picture that needs nothing else.
std::string to_text(const BuildReport& report);
std::string to_json(const BuildReport& report);
std::string to_csv(const BuildReport& report);
std::string to_svg(const BuildReport& report);

}  // namespace bspview
