#pragma once

#include <array>
#include <span>

#include "core/scene/scene.h"

namespace bspview {

inline constexpr std::size_t object_kind_count = 4;

/// Costs of testing an object, C_I, by ObjectKind: where C_T is 1, trees that are built with them
/// are the fastest for rays to go through. As `bspeval tune` fits them.
inline constexpr std::array<double, object_kind_count> test_costs{1.5, 1.5, 1.5, 1.5};

/// By ObjectKind, its share of the surface of the objects' boxes: of the tests of rays that go
/// anywhere. They add up to 1. `boxes`: one an object; empty ones do not count.
std::array<double, object_kind_count> surface_shares(const Scene& scene,
                                                     std::span<const Aabb> boxes);

/// The mean of the costs of testing the objects of a scene.
float mean_test_cost(const Scene& scene, std::span<const Aabb> boxes);

}  // namespace bspview
