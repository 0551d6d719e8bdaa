#include "core/bsp/grow.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace bspview {
namespace {

/// The tree down to `depth`; nullopt when it passes the memory limit. A lone root never does.
std::optional<GrownTree> grow_to(int depth, GrowTree* grow, BuildJob job,
                                 const PartsSource& parts) {
  MemoryMeter meter(job.memory_limit);
  if (depth > job.depth) job.meter = &meter;
  job.max_depth = depth;
  Branch branch;
  try {
    grow(job, parts(), branch);
  } catch (const MemoryLimitPassed&) {
    return {};
  }
  if (job.inner) job.inner->lists = std::move(branch.inner);
  return GrownTree{std::move(branch.nodes), std::move(branch.references),
                   std::move(branch.deferred)};
}

}  // namespace

GrownTree grow_tree(GrowTree* grow, BuildJob job, const PartsSource& parts) {
  if (auto whole = grow_to(job.max_depth, grow, job, parts)) return *std::move(whole);
  if (job.inner) job.inner->meter.give_up();
  job.inner = nullptr;
  job.progress = nullptr;  // which cannot go back
  int fitting = job.depth, too_deep = job.max_depth;
  std::optional<GrownTree> cut;
  while (too_deep - fitting > 1) {
    const int depth = fitting + (too_deep - fitting) / 2;
    cut.reset();  // never two trees at once
    cut = grow_to(depth, grow, job, parts);
    (cut ? fitting : too_deep) = depth;
  }
  if (!cut) cut = grow_to(fitting, grow, job, parts);
  cut->memory_limit_reached = true;
  return *std::move(cut);
}

}  // namespace bspview
