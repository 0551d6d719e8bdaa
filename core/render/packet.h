#pragma once

#include <span>

#include "core/render/intersect.h"

namespace bspview {

/// Nearest hits of rays, those of several at a time where neighbours in `rays` run the same way:
/// eye rays of neighbouring pixels, shadow rays towards one light. Each is the hit that closest_hit
/// finds by the robust walk and exact arithmetic, bit for bit, but for its leaf, which stays
/// no_leaf. Vector instructions of the processor it runs on (Highway). The spans are equally long.
void closest_hits(const World& world, std::span<const Ray> rays, SideRule rule,
                  std::span<Hit> hits);

/// Whether rays hit anything in their interval: as any_hit, 1 or 0.
void any_hits(const World& world, std::span<const Ray> rays, SideRule rule, std::span<char> hits);

/// Rays at a time, and the instruction set.
int packet_width();
const char* packet_instructions();

}  // namespace bspview
