#pragma once

#include <atomic>
#include <memory>

#include "core/bsp/partial_tree.h"
#include "core/render/accelerator.h"

namespace bspview {

class LazyTree;

/// A leaf that was put off, and what rays make of it. Where there are not many objects, it stays a
/// leaf, with boxes around them, until rays have lost there about what splitting it costs: never
/// more than twice the time of whoever knew beforehand how many rays come, and most leaves see few.
/// What a ray loses is known from the areas of the boxes: nothing where neighbours in the scene's
/// order are neighbours in space, as in most scenes.
class LazyPart {
 public:
  LazyPart(const LazyTree& whole, DeferredLeaf leaf);
  LazyPart(const LazyPart&) = delete;
  LazyPart& operator=(const LazyPart&) = delete;

  /// What rays walk below the leaf: what is there, or what this call makes of it while others that
  /// come meanwhile wait. Where memory does not suffice for a tree, the leaf with its objects.
  const Accelerator& accelerator() const {
    const Accelerator* const made = made_.load(std::memory_order_acquire);
    return made != nullptr && !is_due() ? *made : make();
  }

  /// The tree below the leaf, which is made if it is not there yet; null where there is no room.
  const Tree* build() const;

  /// The tree below the leaf; null where it is not built.
  const Tree* tree() const {
    const Below* const below = below_.load(std::memory_order_acquire);
    return below != nullptr ? &below->tree : nullptr;
  }
  /// Of tree().
  std::span<const std::shared_ptr<const LazyPart>> parts() const {
    return below_.load(std::memory_order_acquire)->accelerator->parts();
  }

  std::uint32_t node() const { return leaf_.node; }  ///< of the tree that the leaf is in
  const Place& place() const { return leaf_.place; }
  std::span<const ObjectPart> objects() const { return leaf_.parts; }  ///< until rays come

 private:
  struct Below {
    Tree tree;
    std::shared_ptr<const Accelerator> accelerator;
  };

  /// Whether a leaf that rays have come to often enough is to be split.
  bool is_due() const {
    const std::uint32_t left = visits_left_.load(std::memory_order_relaxed);
    if (left == 0) [[likely]]
      return false;
    visits_left_.store(left - 1, std::memory_order_relaxed);
    return left == 1;
  }

  const Accelerator& make() const;
  const Accelerator& make_leaf() const;
  const Accelerator& make_tree() const;

  const LazyTree& whole_;

  // Written under a lock, and read by others where the two pointers are there.
  mutable DeferredLeaf leaf_;
  mutable std::unique_ptr<const Accelerator> leaf_alone_;
  mutable std::unique_ptr<const Below> tree_below_;

  mutable std::atomic<const Accelerator*> made_ = nullptr;
  mutable std::atomic<const Below*> below_ = nullptr;
  mutable std::atomic<std::uint32_t> visits_left_ = 0;  ///< 0: it stays what it is
};

}  // namespace bspview
