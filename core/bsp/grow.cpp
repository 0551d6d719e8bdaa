#include "core/bsp/grow.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace bspview {
namespace {

/// The tree down to `depth`; nullopt when it passes the memory limit. A lone root never does.
std::optional<GrownTree> grow_to(int depth, const GrowBranch& grow, BuildJob job) {
  MemoryMeter meter(job.memory_limit);
  if (depth > job.depth) job.meter = &meter;
  job.max_depth = depth;
  Branch branch;
  try {
    grow(job, branch);
  } catch (const MemoryLimitPassed&) {
    return {};
  }
  if (job.inner) job.inner->lists = std::move(branch.inner);
  return GrownTree{std::move(branch.nodes), std::move(branch.references),
                   std::move(branch.deferred)};
}

/// Builds of one tree to different depths, one of which is the last. They tell of equal shares of
/// the work.
class Tries {
 public:
  Tries(const GrowBranch& grow, const BuildJob& job, int most)
      : grow_(grow), job_(job), share_(1.0 / most) {}

  std::optional<GrownTree> to_depth(int depth) const {
    if (!job_.progress) return grow_to(depth, grow_, job_);
    Watch watch;
    watch.progress = [this](double more) { job_.progress->tell(more * share_); };
    BuildProgress progress(watch, job_.input.boxes.size());
    BuildJob job = job_;
    job.progress = &progress;
    std::optional<GrownTree> tree = grow_to(depth, grow_, job);
    progress.tell_rest();
    return tree;
  }

 private:
  const GrowBranch& grow_;
  const BuildJob& job_;
  const double share_;
};

}  // namespace

GrownTree grow_tree(const GrowBranch& grow, BuildJob job) {
  if (auto whole = grow_to(job.max_depth, grow, job)) return *std::move(whole);
  if (job.inner) job.inner->give_up();
  job.inner = nullptr;
  if (job.progress) job.progress->begin_again();
  int fitting = job.depth, too_deep = job.max_depth;
  const auto between = static_cast<unsigned>(too_deep - fitting - 1);
  const Tries tries(grow, job, std::bit_width(between) + 1);
  std::optional<GrownTree> cut;
  while (too_deep - fitting > 1) {
    const int depth = fitting + (too_deep - fitting) / 2;
    cut.reset();  // never two trees at once
    cut = tries.to_depth(depth);
    (cut ? fitting : too_deep) = depth;
  }
  if (!cut) cut = tries.to_depth(fitting);
  cut->memory_limit_reached = true;
  return *std::move(cut);
}

}  // namespace bspview
