// Wide nodes by bins, small ones exactly (see bin_planes.cpp and few_planes.cpp).

#include "core/bsp/binned_parts.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {

void grow_sah_binned(const BuildJob& job, ObjectParts parts, Branch& branch) {
  BinnedParts objects(job, parts, branch.scratch);
  Recursion<BinnedParts>(job).grow_root(objects, branch);
}

}  // namespace bspview
