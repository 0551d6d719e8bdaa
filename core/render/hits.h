#pragma once

#include <span>

#include "core/render/intersect.h"

namespace bspview {

// Hits by the robust walk and exact arithmetic, with the vector instructions of the processor the
// program runs on (Highway). Each answer is that of closest_hit and any_hit, bit for bit, but for
// the leaf, which stays no_leaf, and for which of several objects any_hit finds. Rays of a world
// without an accelerator, and rays that are none, go through the binary tree one by one.

/// Nearest hit of a ray.
Hit fast_closest_hit(const World& world, const Ray& ray, SideRule rule);

/// Whether a ray hits anything in its interval: some object, or no_index.
std::uint32_t fast_any_hit(const World& world, const Ray& ray, SideRule rule);

/// The same for many rays, several at a time where neighbours in `rays` run the same way (eye rays
/// of neighbouring pixels, shadow rays towards one light). The spans are equally long.
void closest_hits(const World& world, std::span<const Ray> rays, SideRule rule,
                  std::span<Hit> hits);
void any_hits(const World& world, std::span<const Ray> rays, SideRule rule,
              std::span<std::uint32_t> objects);

/// Whether these functions answer for `rules`: the world has an accelerator, and neither another
/// walk nor another arithmetic is asked for.
inline bool is_fast(const World& world, const TraceRules& rules) {
  return world.accelerator != nullptr && rules.traversal == Traversal::robust &&
         rules.arithmetic == Arithmetic::exact;
}

/// Walks as closest_hits, each ray to the end of its interval, without object tests; or makes
/// ready, no more: to measure the walk by (record.h). Answers a sum of the names of the leaves,
/// lest it be left out. Needs an accelerator.
std::uint64_t walk_together(const World& world, std::span<const Ray> rays, bool walks);

/// The same of one ray, by itself.
std::uint64_t walk_alone(const World& world, const Ray& ray, bool walks);

/// Rays at a time, and the instruction set.
int packet_width();
const char* packet_instructions();

}  // namespace bspview
