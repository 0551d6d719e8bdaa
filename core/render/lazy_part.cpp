#include "core/render/lazy_part.h"

#include "core/render/lazy_tree.h"

namespace bspview {
namespace {

// Nanoseconds, about: to test a block, or any other object; and for each object of a leaf, to build
// all that is below, or the next few levels.
constexpr double block_time = 17.0, object_time = 40.0;
constexpr double build_time = 2500.0, levels_time = 200.0;

/// After so many, rays that test all of a leaf have cost as much as its splitting costs.
std::uint32_t visits_worth_a_split(const Accelerator& leaf, std::size_t objects) {
  const WideLeaf in_it = leaf.leaf(leaf.lone_leaf());
  const double test_time = block_time * in_it.block_count + object_time * in_it.other_count;
  const double split_time = objects <= most_built_objects ? build_time : levels_time;
  return 1 + static_cast<std::uint32_t>(split_time * static_cast<double>(objects) / test_time);
}

std::vector<std::uint32_t> ids_of(std::span<const ObjectPart> parts) {
  std::vector<std::uint32_t> ids;
  ids.reserve(parts.size());
  for (const ObjectPart& part : parts) ids.push_back(part.object);
  return ids;
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
  leaf_alone_ = std::make_unique<const Accelerator>(
      Accelerator::lone_leaf(whole_.scene_, ids_of(leaf_.parts)));
  visits_left_.store(visits_worth_a_split(*leaf_alone_, leaf_.parts.size()),
                     std::memory_order_relaxed);
  made_.store(leaf_alone_.get(), std::memory_order_release);
  return *leaf_alone_;
}

const Accelerator& LazyPart::make_tree() const {
  visits_left_.store(0, std::memory_order_relaxed);
  auto below = std::make_unique<Below>();
  below->accelerator = whole_.grow(leaf_, below->tree);
  if (below->accelerator == nullptr) {
    if (leaf_alone_ == nullptr) make_leaf();
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
