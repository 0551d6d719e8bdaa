#pragma once

#include <span>

#include "core/bsp/build_job.h"

namespace bspview {

/// About the cheapest plane: see bin_planes.cpp. Its tests are infinite when the cell has no room
/// for one.
Split cheapest_of_bins(const BuildJob& job, std::span<const ObjectPart> parts, const Aabb& cell);

}  // namespace bspview
