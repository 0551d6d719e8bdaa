#include "core/bsp/branch.h"

namespace bspview {

void splice(Branch& whole, std::uint32_t slot, const Branch& part) {
  // Node 0 of the part takes the slot, so node i >= 1 of it lands at first_node + i.
  const auto first_node = static_cast<std::uint32_t>(whole.nodes.size()) - 1;
  const auto first_reference = static_cast<std::uint32_t>(whole.references.size());
  const auto moved = [&](const Node& node) {
    return node.is_leaf() ? Node::make_leaf(node.first_reference() + first_reference, node.count())
                          : Node::make_inner(node.axis(), node.split(), node.left() + first_node);
  };
  whole.nodes[slot] = moved(part.nodes[0]);
  whole.nodes.reserve(whole.nodes.size() + part.nodes.size() - 1);
  for (std::size_t i = 1; i < part.nodes.size(); ++i) whole.nodes.push_back(moved(part.nodes[i]));
  whole.references.insert(whole.references.end(), part.references.begin(), part.references.end());
  whole.memory_limit_reached |= part.memory_limit_reached;
}

std::size_t leaf_bytes(std::size_t objects) {
  return sizeof(Node) + objects * sizeof(std::uint32_t);
}

bool has_room(std::size_t memory, std::size_t left_objects, std::size_t right_objects) {
  return sizeof(Node) + leaf_bytes(left_objects) + leaf_bytes(right_objects) <= memory;
}

ChildMemory share_memory(std::size_t memory, std::size_t left_objects, std::size_t right_objects) {
  const std::size_t left = leaf_bytes(left_objects);
  const std::size_t right = leaf_bytes(right_objects);
  const std::size_t spare = memory - sizeof(Node) - left - right;
  const double all = static_cast<double>(left_objects) + static_cast<double>(right_objects);
  const double share = all > 0.0 ? static_cast<double>(left_objects) / all : 0.5;
  const auto spare_left = static_cast<std::size_t>(static_cast<double>(spare) * share);
  return {left + spare_left, right + (spare - spare_left)};
}

}  // namespace bspview
