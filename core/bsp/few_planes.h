#pragma once

#include <span>

#include "core/bsp/build_job.h"
#include "core/shape/outline.h"

namespace bspview {

inline constexpr std::size_t most_few_parts = 32;

/// A box, and in its fourth lanes what testing its object costs in units of the job's C_I.
struct FewBox : LaneBox {
  float tests() const { return lo[3]; }
};

inline FewBox few_box(const Aabb& box, float tests) {
  return {lane_box(box, tests)};
}

/// The plane that the sweep over the events of at most most_few_parts boxes finds: the cheapest of
/// all, among equals that on the lowest axis, then the lowest. Its tests are infinite when the cell
/// has no room for one, and where all boxes reach across the cell, so that none pays.
Split cheapest_of_few(const BuildJob& job, std::span<const FewBox> boxes, const Aabb& cell);

}  // namespace bspview
