#pragma once

#include "core/render/intersect.h"

namespace bspview {

// The same with other arithmetic than `exact`; for the observers of core/bsp/observer.h.
template <class Observer>
Hit closest_hit_otherwise(const World& world, const Ray& ray, const TraceRules& rules,
                          Observer& observer);
template <class Observer>
std::uint32_t any_hit_otherwise(const World& world, const Ray& ray, const TraceRules& rules,
                                Observer& observer);

/// closest_hit by the arithmetic of `rules`.
template <class Observer>
Hit trace_closest(const World& world, const Ray& ray, const TraceRules& rules, Observer& observer) {
  if (rules.arithmetic != Arithmetic::exact)
    return closest_hit_otherwise(world, ray, rules, observer);
  return closest_hit(world, ray, rules, observer);
}

/// any_hit by the arithmetic of `rules`.
template <class Observer>
std::uint32_t trace_any(const World& world, const Ray& ray, const TraceRules& rules,
                        Observer& observer) {
  if (rules.arithmetic != Arithmetic::exact) return any_hit_otherwise(world, ray, rules, observer);
  return any_hit(world, ray, rules, observer);
}

}  // namespace bspview
