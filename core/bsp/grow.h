#pragma once

#include <fmt/format.h>

#include <functional>
#include <new>
#include <vector>

#include "core/base/result.h"
#include "core/bsp/branch.h"

namespace bspview {

/// What one run of a builder leaves.
struct GrownTree {
  Nodes nodes;
  References references;
  std::vector<DeferredLeaf> deferred;  ///< in the order of their nodes
  bool memory_limit_reached = false;
};

/// Grows a tree into an empty branch; called once a try.
using GrowBranch = std::function<void(const BuildJob& job, Branch& branch)>;

/// The whole tree, or else the deepest one that job.memory_limit allows. A lone root always fits.
GrownTree grow_tree(const GrowBranch& grow, BuildJob job);

/// What work() answers, or the error that every builder answers where it throws.
template <class Work>
auto with_build_errors(const BuildInput& input, const Work& work) -> Result<decltype(work())> {
  if (input.boxes.size() > most_objects) {
    return Error{
        fmt::format("a tree holds at most {} objects, not {}", most_objects, input.boxes.size())};
  }
  try {
    return work();
  } catch (const BuildStopped&) {
    return Error{"stopped"};
  } catch (const InnerObjectsPassed&) {
    return Error{"what the inner nodes hold takes too much memory"};
  } catch (const std::bad_alloc&) {
    return no_memory_for_tree();
  }
}

}  // namespace bspview
