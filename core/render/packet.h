#pragma once

#include <span>

#include "core/render/intersect.h"

namespace bspview {

/// Nearest hits of rays, several at a time where neighbours in `rays` run the same way (eye rays of
/// neighbouring pixels, shadow rays towards one light), the others one by one. Each is the hit that
/// closest_hit finds by the robust walk and exact arithmetic, bit for bit, but for its leaf, which
/// stays no_leaf. Vector instructions of the processor it runs on (Highway). The spans are equally
/// long.
void closest_hits(const World& world, std::span<const Ray> rays, SideRule rule,
                  std::span<Hit> hits);

/// An object that each ray hits in its interval, as any_hit, though not always the same one.
void any_hits(const World& world, std::span<const Ray> rays, SideRule rule,
              std::span<std::uint32_t> objects);

/// Rays at a time, and the instruction set.
int packet_width();
const char* packet_instructions();

}  // namespace bspview
