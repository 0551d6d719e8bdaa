#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/eval/bench/rays.h"
#include "core/eval/kernel.h"
#include "core/render/test_cost.h"

namespace bspview {

/// Traces rays of one scene that it holds in the layout it likes best. One thread a tracer.
class Tracer {
 public:
  virtual ~Tracer() = default;
  /// Takes the rays over; nothing of this is timed.
  virtual void load(BenchKind kind, std::span<const Ray> rays) = 0;
  /// Answers the loaded rays, once a load.
  virtual void trace() = 0;
  /// One answer a ray; of shadow rays only whether there is an object.
  virtual void read(std::span<RayResult> results) const = 0;
};

/// Makes tracers for one scene; called from any thread.
using MakeTracer = std::function<std::unique_ptr<Tracer>()>;

/// What takes part in the benchmark of speed.
struct Peer {
  enum class Answers {
    robust,  ///< as good as it can
    fast     ///< gives up some for speed
  };
  enum class Width { one, many };  ///< rays at a time

  std::string name;  ///< short: a key in files
  std::string what;  ///< one line for people
  Answers answers = Answers::robust;
  Width width = Width::one;
  bool foreign = false;
  std::optional<BuildParams> build;           ///< of its tree; nothing: what was asked for
  TestCosts test_costs = default_test_costs;  ///< of its tree
  /// Builds all it needs of the scene besides the tree.
  std::function<MakeTracer(const World&)> enter;
};

/// Whether it has no tree.
inline bool is_naive(const Peer& peer) {
  return peer.build && peer.build->builder == Builder::naive;
}

/// A kernel of ours as a peer.
Peer peer_of(Kernel kernel, Peer::Answers answers, Peer::Width width);

/// Ours; the first is the default, whose answers the others are held against.
std::vector<Peer> own_peers();

/// Embree, one ray, eight rays and streams of 64, each by default and robust. None where the build
/// found no libembree-dev.
std::vector<Peer> embree_peers();

}  // namespace bspview
