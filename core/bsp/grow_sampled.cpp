// Planes are found by bins (see bin_planes.cpp) for several levels at once, among a sample of the
// objects; then every object goes to its leaf.

#include "core/bsp/grow_sampled.h"

#include <algorithm>
#include <utility>

#include "core/bsp/binned_parts.h"
#include "core/bsp/recursion.h"

namespace bspview {
namespace {

/// Sampled objects in a leaf, at most: enough to find planes above it by.
constexpr std::size_t most_in_leaf = 96;
static_assert(most_in_leaf >= most_few_parts);

std::size_t stride_of(const BuildJob& job) {
  return job.deferred_size / most_in_leaf;
}

/// One of each `stride` parts, not always the same one: objects often come in groups of one size.
ObjectParts take_sample(const PartsView& parts, std::size_t stride) {
  ObjectParts sample;
  sample.reserve(parts.size() / stride);
  for (std::size_t first = 0; first + stride <= parts.size(); first += stride) {
    const std::uint64_t scrambled = (first + 1) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
    const ObjectPart part = parts[first + (scrambled >> 32) % stride];
    if (is_placeable(part.box)) sample.push_back(part);
  }
  return sample;
}

class SampledTree {
 public:
  SampledTree(const BuildJob& job, const PartsView& parts)
      : job_(job), most_(job.deferred_size / stride_of(job)) {
    const std::size_t stride = stride_of(job);
    BuildJob sampled = job;
    sampled.costs.intersection *= static_cast<double>(stride);
    sampled.leaf_size /= stride;
    sampled.deferred_size = most_;
    sampled.task_count = std::max(job.task_count / stride, std::size_t{1024});
    sampled.meter = nullptr;
    ObjectParts sample = take_sample(parts, stride);
    Branch branch;
    BinnedParts objects(sampled, sample, branch.scratch);
    Recursion<BinnedParts>(sampled).grow_root(objects, branch);
    tree_.nodes = std::move(branch.nodes);
    tree_.cells.resize(tree_.nodes.size());
    number(0, {job.box, job.depth});
  }

  void fill(const PartsView& parts, Branch& branch) {
    tree_.leaf_count = leaves_.size();
    std::vector<ObjectParts> dealt = deal_parts(job_, parts, tree_);
    std::size_t references = 0;
    for (const ObjectParts& leaf : dealt) references += leaf.size();
    branch.nodes = std::move(tree_.nodes);
    branch.references.resize(references);
    references = 0;
    for (std::size_t i = 0; i < dealt.size(); ++i) {
      const Leaf& leaf = leaves_[i];
      const std::size_t count = dealt[i].size();
      branch.nodes[leaf.node] = Node::make_leaf(static_cast<std::uint32_t>(references),
                                                static_cast<std::uint32_t>(count));
      for (const ObjectPart& part : dealt[i]) branch.references[references++] = part.object;
      if (leaf.is_wide || count <= job_.leaf_size || leaf.place.depth >= job_.max_depth) continue;
      branch.deferred.push_back({leaf.node, leaf.place, std::move(dealt[i])});
    }
  }

 private:
  struct Leaf {
    std::uint32_t node;
    Place place;
    bool is_wide;  // yet no plane pays
  };

  void number(std::uint32_t index, const Place& place) {
    tree_.cells[index] = place.cell;
    const Node node = tree_.nodes[index];
    if (node.is_leaf()) {
      leaves_.push_back({index, place, node.count() > most_});
      tree_.nodes[index] = Node::make_leaf(static_cast<std::uint32_t>(leaves_.size() - 1), 0);
      return;
    }
    const Cells cells = split_cell(place.cell, node.axis(), node.split());
    number(node.left(), {cells.left, place.depth + 1});
    number(node.right(), {cells.right, place.depth + 1});
  }

  const BuildJob& job_;
  const std::size_t most_;  // sampled objects in a leaf that is put off
  DealTree tree_;
  std::vector<Leaf> leaves_;
};

}  // namespace

bool is_worth_sampling(const BuildJob& job, std::size_t objects) {
  return stride_of(job) > 1 && objects >= 2 * job.deferred_size;
}

void grow_sampled(const BuildJob& job, const PartsView& parts, Branch& branch) {
  SampledTree(job, parts).fill(parts, branch);
  meter(job, branch);
}

}  // namespace bspview
