#pragma once

#include <string>
#include <vector>

#include "core/base/watch.h"
#include "core/eval/bench/peer.h"

namespace bspview {

struct BenchParams {
  BuildParams build;         ///< of our trees; its threads build, none of them is timed
  std::size_t rays = 65536;  ///< about as many of every kind
  int repeats = 9;
  std::vector<BenchKind> kinds{BenchKind::primary, BenchKind::shadow, BenchKind::scattered};
  int segments = 8;  ///< of round shapes as triangles, see triangulate
  std::uint64_t seed = 0;
};

/// What one peer did with the rays of one kind.
struct PeerTimes {
  std::size_t rays = 0;             ///< traced by it: a slow one gets a part, evenly taken
  std::vector<double> nanoseconds;  ///< a ray, by repeat; empty: it did not take part
  std::size_t lost = 0;             ///< the default hits something, it does not
  std::size_t phantom = 0;          ///< it does, the default does not
  std::size_t elsewhere = 0;        ///< both do, at different places
  std::size_t wrong() const { return lost + phantom + elsewhere; }
};

struct KindTimes {
  BenchKind kind = BenchKind::primary;
  std::size_t rays = 0;
  std::vector<PeerTimes> peers;  ///< in the order of the peers
};

/// What was measured on one scene.
struct SceneTimes {
  std::string name;
  int segments = 0;  ///< 0: every shape was what it is
  ObjectCounts objects;
  std::vector<KindTimes> kinds;  ///< only those that the scene has rays of
};

/// Records rays once, holds the answers of all peers against those of the first, then times them on
/// one thread, repeat after repeat over all peers, by the processor time of the thread.
/// watch.progress adds up to 1. Fails when a stop is requested or a tree cannot be built.
Result<SceneTimes> measure_scene(const Scene& scene, std::span<const Peer> peers,
                                 const BenchParams& params, const Watch& watch = {});

/// A peer that tests every object gets no scene with more of them.
inline constexpr std::size_t most_naive_objects = 10000;

}  // namespace bspview
