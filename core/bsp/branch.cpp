#include "core/bsp/branch.h"

namespace bspview {
namespace {

/// Puts those of `part`, which becomes empty, at the end.
void append(const BuildJob& job, InnerLists& whole, InnerLists& part) {
  make_room(job, whole.lists(), part.size());
  append(job, whole.lists(), std::span(std::as_const(part).lists()));
  whole.take_over(part);
}

}  // namespace

void meter(const BuildJob& job, Branch& branch) {
  if (job.meter) job.meter->add(branch.bytes() - branch.metered);
  branch.metered = branch.bytes();
}

void splice(const BuildJob& job, Branch& whole, std::uint32_t slot, Branch& part) {
  // Node 0 of the part takes the slot, so node i >= 1 of it lands at first_node + i.
  const auto first_node = static_cast<std::uint32_t>(whole.nodes.size()) - 1;
  const auto first_reference = static_cast<std::uint32_t>(whole.references.size());
  const auto moved = [&](const Node& node) {
    return node.is_leaf() ? Node::make_leaf(node.first_reference() + first_reference, node.count())
                          : Node::make_inner(node.axis(), node.split(), node.left() + first_node);
  };
  whole.nodes[slot] = moved(part.nodes[0]);
  make_room(job, whole.nodes, part.nodes.size() - 1);
  job.for_each(part.nodes.size() - 1, light_steps,
               [&](std::size_t i) { whole.nodes.push_back(moved(part.nodes[i + 1])); });
  make_room(job, whole.references, part.references.size());
  append(job, whole.references, std::span<const std::uint32_t>(part.references));
  for (DeferredLeaf& leaf : part.deferred) {
    leaf.node = leaf.node == 0 ? slot : leaf.node + first_node;
    whole.deferred.push_back(std::move(leaf));
  }
  append(job, whole.inner, part.inner);
  whole.metered += part.metered - sizeof(Node);
}

}  // namespace bspview
