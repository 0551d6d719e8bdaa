#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/bsp/node.h"
#include "core/bsp/scratch_stack.h"

namespace bspview {

/// What one branch of the recursion writes to. A branch that runs beside another has its own and
/// is spliced in afterwards, so that the tree does not depend on who ran first.
struct Branch {
  std::vector<Node> nodes;  ///< [0] is the branch's root; children come in pairs behind parents
  std::vector<std::uint32_t> references;
  bool memory_limit_reached = false;
  ScratchStack scratch;
};

/// Puts the root of `part` at `slot` of `whole`, its other nodes and its references at the end.
void splice(Branch& whole, std::uint32_t slot, const Branch& part);

/// Bytes of nodes and references that the two children of a node may take.
struct ChildMemory {
  std::size_t left = 0, right = 0;
};

/// What a node that becomes a leaf takes.
std::size_t leaf_bytes(std::size_t objects);

/// Whether a node that may take `memory` bytes has room for two children with so many objects.
bool has_room(std::size_t memory, std::size_t left_objects, std::size_t right_objects);

/// Each child gets what it needs as a leaf, and what is left over in proportion to its objects:
/// the result depends on the node alone, not on the order in which the tree is built.
ChildMemory share_memory(std::size_t memory, std::size_t left_objects, std::size_t right_objects);

}  // namespace bspview
