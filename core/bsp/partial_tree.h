#pragma once

#include <stop_token>
#include <vector>

#include "core/bsp/build.h"
#include "core/bsp/deferred_leaf.h"

namespace bspview {

/// A tree whose leaves of many objects are put off. It is a tree like any other: what is put off is
/// a leaf in it, and is listed in tree.unbuilt, too.
struct PartialTree {
  Tree tree;
  std::vector<DeferredLeaf> deferred;  ///< one an element of tree.unbuilt
};

/// Of what is put off, nodes with at most so many objects are built to the last leaf at once, and
/// others into nodes that are put off again.
inline constexpr std::size_t most_built_objects = 64;

/// Nodes with more objects are too slow to test for them to stay leaves for even a few rays.
inline constexpr std::size_t most_tested_objects = 1024;

/// The upper part of what build_tree builds, with the same errors. `sah` prices the planes of nodes
/// with many objects by bins, and those of very many by a sample of them; every other builder
/// splits them as ever. `naive` has no upper part.
Result<PartialTree> build_partial_tree(const BuildInput& input, const BuildParams& params,
                                       std::stop_token stop = {});

/// The upper part, or if the objects are few all, of what is below a leaf that was put off. `whole`
/// is the tree that build_partial_tree made of `input`. Runs on the calling thread alone. Takes at
/// most `memory_limit` bytes, as build_tree does; fails when memory runs out.
Result<PartialTree> build_deferred(const BuildInput& input, const Tree& whole,
                                   const DeferredLeaf& leaf, std::size_t memory_limit);

}  // namespace bspview
