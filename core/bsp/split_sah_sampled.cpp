// Wide nodes of trees that grow: planes are found among a sample of the objects, by bins (see
// bin_planes.cpp), for several levels at once; then every object goes to its leaf.

#include "core/bsp/binned_parts.h"
#include "core/bsp/dealt_parts.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

/// Sampled objects in a leaf, at most: enough to find planes above it by.
constexpr std::size_t most_in_leaf = 96;
static_assert(most_in_leaf >= most_few_parts);

/// One of each `stride` parts, not always the same one: objects often come in groups of one size.
ObjectParts take_sample(std::span<const ObjectPart> parts, std::size_t stride) {
  ObjectParts sample;
  sample.reserve(parts.size() / stride);
  for (std::size_t first = 0; first + stride <= parts.size(); first += stride) {
    const std::uint64_t scrambled = (first + 1) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
    sample.push_back(parts[first + (scrambled >> 32) % stride]);
  }
  return sample;
}

class SampledTree {
 public:
  SampledTree(const BuildJob& job, std::span<const ObjectPart> parts, std::size_t stride)
      : job_(job), most_(job.deferred_size / stride) {
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

  void fill(std::span<const ObjectPart> parts, Branch& branch) {
    tree_.leaf_count = leaves_.size();
    std::vector<ObjectParts> dealt = deal_parts(job_, parts, tree_);
    std::size_t references = 0;
    for (const ObjectParts& leaf : dealt) references += leaf.size();
    branch.nodes = tree_.nodes;
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

void grow_sah_sampled(const BuildJob& job, ObjectParts parts, Branch& branch) {
  const std::size_t stride = job.deferred_size / most_in_leaf;
  if (stride < 2 || parts.size() < 2 * job.deferred_size)
    return grow_sah_binned(job, std::move(parts), branch);
  SampledTree(job, parts, stride).fill(parts, branch);
  meter(job, branch);
}

}  // namespace bspview
