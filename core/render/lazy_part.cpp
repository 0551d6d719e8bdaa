#include "core/render/lazy_part.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/render/lazy_tree.h"

namespace bspview {
namespace {

// Nanoseconds, about: what a ray takes for a cell, and what it takes, for each object, to build all
// that is below a leaf, or the next few levels.
constexpr double cell_time = 10.0, build_time = 2500.0, levels_time = 200.0;

constexpr double cells_below = 8.0;  // that a ray passes where the leaf is split

/// Of boxes in boxes: how many a ray through the outermost one is expected to pass.
double expected_cells(const WideTree& boxes) {
  double areas = 0.0;
  Aabb outermost;
  for (const WideNode& node : boxes.nodes) {
    for (int slot = 0; slot < WideNode::width; ++slot) {
      const Aabb box = node.box(slot);
      if (box.empty()) continue;
      areas += half_area(box);
      if (&node == &boxes.nodes.front()) outermost.grow(box);
    }
  }
  const double area = half_area(outermost);
  return area > 0.0 ? areas / area : static_cast<double>(WideNode::width * boxes.nodes.size());
}

/// After so many, rays have lost as much in a leaf as its splitting costs; 0: they lose nothing.
std::uint32_t visits_worth_a_split(std::size_t objects, const WideTree& boxes) {
  const double lost = cell_time * (expected_cells(boxes) - cells_below);
  if (!(lost > 0.0)) return 0;
  const double split = objects <= most_built_objects ? build_time : levels_time;
  return static_cast<std::uint32_t>(
      std::clamp(split * static_cast<double>(objects) / lost, 1.0, 1e9));
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
  visits_left_.store(visits_worth_a_split(leaf_.parts.size(), leaf_alone_->tree()),
                     std::memory_order_relaxed);
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
