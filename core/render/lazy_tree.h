#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>

#include "core/bsp/partial_tree.h"
#include "core/render/accelerator.h"
#include "core/render/lazy_part.h"
#include "core/render/scene_tree.h"

namespace bspview {

/// A scene's tree that grows where rays go: its upper part is built at once, the rest by the first
/// rays that need it. Rays of any number of threads may walk it at the same time; what is there
/// they find without a lock. Every answer is that of the tree that build_scene_tree builds.
///
/// Parts share the memory limit of the tree. A part for which there is no room is tested as a leaf.
/// A part takes milliseconds: whoever stops rays waits no longer than that.
class LazyTree {
 public:
  /// Errors as build_scene_tree; the builder `naive` has nothing to put off. The scene outlives the
  /// result.
  static Result<std::shared_ptr<const LazyTree>> build(const Scene& scene,
                                                       const BuildParams& params,
                                                       std::stop_token stop = {});

  /// The tree of the world is the upper part alone.
  World world() const { return {scene_, top_, accelerator_.get(), this}; }

  /// One tree of all that is built; leaves that are not are in Tree::unbuilt. With the accelerator
  /// of world(), it makes a world whose tree can be counted in.
  Result<Tree> graft() const;

  /// Until the upper part was there, and of building all parts so far, one after the other.
  double build_seconds() const { return seconds_; }
  double part_seconds() const { return part_seconds_; }

 private:
  friend class LazyPart;

  LazyTree(const Scene& scene, const std::stop_token& stop)
      : scene_(scene), objects_(scene, default_test_costs, stop) {}

  /// Builds the part below a leaf; null where there is no room.
  std::shared_ptr<const Accelerator> grow(const DeferredLeaf& leaf, Tree& tree) const;
  std::shared_ptr<const Accelerator> lay_out(PartialTree& part, std::stop_token stop) const;
  std::size_t memory_left() const;

  const Scene& scene_;
  const SceneBuildInput objects_;
  Tree top_;
  std::shared_ptr<const Accelerator> accelerator_;
  double seconds_ = 0.0;

  /// Shared by the parts.
  std::mutex& lock_of(const LazyPart& part) const {
    return locks_[(reinterpret_cast<std::uintptr_t>(&part) >> 6) % locks_.size()];
  }

  mutable std::array<std::mutex, 64> locks_;
  mutable std::atomic<std::size_t> bytes_ = 0;  ///< of the trees
  mutable std::atomic<bool> memory_limit_reached_ = false;
  mutable std::atomic<double> part_seconds_ = 0.0;
};

}  // namespace bspview
