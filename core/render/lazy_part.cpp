#include "core/render/lazy_part.h"

#include "core/base/parallel.h"
#include "core/render/lazy_tree.h"

namespace bspview {
namespace {

// Nanoseconds, about, for each object of a leaf: what a ray that comes to the leaf takes longer
// than it would below, and what it takes to build all that is below, or the next few levels.
constexpr double ray_time = 0.5, build_time = 2500.0, levels_time = 200.0;

/// After so many, rays have lost as much in a leaf as its splitting costs.
std::uint32_t visits_worth_a_split(std::size_t objects) {
  return static_cast<std::uint32_t>((objects <= most_built_objects ? build_time : levels_time) /
                                    ray_time);
}

}  // namespace

LazyPart::LazyPart(const LazyTree& whole, DeferredLeaf leaf)
    : whole_(whole), leaf_(std::move(leaf)) {}

const Accelerator& LazyPart::make() const {
  const std::lock_guard lock(whole_.lock_of(*this));
  const Accelerator* const made = made_.load(std::memory_order_relaxed);
  if (made == nullptr) return leaf_.parts.size() <= most_tested_objects ? make_leaf() : make_tree();
  return made == leaf_alone_.get() ? make_tree() : *made;
}

const Tree* LazyPart::build() const {
  if (const Tree* made = tree()) return made;
  const std::lock_guard lock(whole_.lock_of(*this));
  if (tree_below_ == nullptr) make_tree();
  return tree();
}

const Accelerator& LazyPart::make_leaf() const {
  leaf_alone_ =
      std::make_unique<const Accelerator>(Accelerator::of_parts(whole_.scene_, leaf_.parts));
  visits_left_.store(visits_worth_a_split(leaf_.parts.size()), std::memory_order_relaxed);
  made_.store(leaf_alone_.get(), std::memory_order_release);
  return *leaf_alone_;
}

const Accelerator& LazyPart::make_tree() const {
  visits_left_.store(0, std::memory_order_relaxed);
  auto below = std::make_unique<Below>();
  below->accelerator = whole_.grow(leaf_, below->tree);
  if (below->accelerator == nullptr) {
    // Alone: a thread that helped others here could come for the lock that it holds.
    if (leaf_alone_ == nullptr) with_threads(1, [&] { make_leaf(); });
    visits_left_.store(0, std::memory_order_relaxed);
    return *leaf_alone_;
  }
  leaf_.parts = {};
  tree_below_ = std::move(below);
  below_.store(tree_below_.get(), std::memory_order_release);
  made_.store(tree_below_->accelerator.get(), std::memory_order_release);
  return *tree_below_->accelerator;
}

}  // namespace bspview
