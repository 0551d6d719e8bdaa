#pragma once

#include <span>

#include "core/bsp/build_job.h"
#include "core/bsp/event.h"

namespace bspview {

/// Writes events that come in ascending order of their parts to `sorted`, which is as long as they
/// are, and leaves anything where they were. O(N) for many events, O(N log N) for few; many
/// threads.
void sort_events(const BuildJob& job, std::span<Event> events, Event* sorted);

/// Merges the sorted `fresh` into the sorted `events`; there is room behind them.
void merge_events(const BuildJob& job, std::span<Event> events, std::span<const Event> fresh);

}  // namespace bspview
