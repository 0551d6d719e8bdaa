#pragma once

#include "core/bsp/branch.h"
#include "core/bsp/build_job.h"

namespace bspview {

/// Grows the whole tree of one builder into `branch`: the rows of build.cpp's table. `parts` holds
/// the placeable objects in ascending order.
using GrowTree = void(const BuildJob& job, ObjectParts parts, Branch& branch);

GrowTree grow_naive;   // one leaf
GrowTree grow_median;  // split_median.cpp
GrowTree grow_median_longest;
GrowTree grow_object_median;  // split_object_median.cpp
GrowTree grow_mb;             // split_mb.cpp
GrowTree grow_sah;            // split_sah_sweep.cpp
GrowTree grow_sah_binned;     // split_sah_binned.cpp

/// That of a builder.
GrowTree* rule_of(Builder builder);

}  // namespace bspview
