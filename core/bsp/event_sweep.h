#pragma once

#include "core/bsp/event_list.h"

namespace bspview {

/// The cheapest of all planes at which a part begins or ends, and of the first and the last for
/// which the cell has room: among equals that on the lowest axis, then the lowest. Its tests
/// are infinite when there is room for none.
Split cheapest_of_events(const BuildJob& job, const EventList& list, const Aabb& cell);

}  // namespace bspview
