#pragma once

#include "core/bsp/branch.h"
#include "core/bsp/dealt_parts.h"

namespace bspview {

/// Whether so many objects, of which a job puts off nodes, are worth it.
bool is_worth_sampling(const BuildJob& job, std::size_t objects);

/// Grows the upper part of a tree by sah, down to nodes of about job.deferred_size objects, which
/// are put off: its planes are those of a tree of a sample. The same for any number of threads.
void grow_sampled(const BuildJob& job, const PartsView& parts, Branch& branch);

}  // namespace bspview
