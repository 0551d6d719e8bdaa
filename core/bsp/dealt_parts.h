#pragma once

#include <span>
#include <vector>

#include "core/bsp/build_job.h"
#include "core/bsp/node.h"

namespace bspview {

/// A small tree whose leaves are numbered, to deal the objects of its root to.
struct DealTree {
  Nodes nodes;              ///< a leaf's first reference is its number
  std::vector<Aabb> cells;  ///< of the nodes
  std::size_t leaf_count = 0;
};

/// For each leaf the parts of objects in it, in their order. Parts that lie on both sides of a
/// plane are clipped where the job says so. The same for any number of threads.
std::vector<ObjectParts> deal_parts(const BuildJob& job, std::span<const ObjectPart> parts,
                                    const DealTree& tree);

}  // namespace bspview
