#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/math/ray.h"
#include "core/render/world.h"

namespace bspview {

/// What rays of the benchmark of speed are, and what is asked about them.
enum class BenchKind {
  primary,   ///< the nearest hit of eye rays
  shadow,    ///< whether anything is between a hit of those and a light
  scattered  ///< the nearest hit of rays from those hits in random directions, shuffled
};
inline constexpr std::size_t bench_kind_count = 3;
std::span<const std::string_view> bench_kind_names();
std::string_view name_of(BenchKind kind);

struct BenchBatch {
  BenchKind kind = BenchKind::primary;
  std::vector<Ray> rays;
};

/// The rays of one kind of a picture of about `count` pixels, in an order that suits packets:
/// - primary: tile after tile of 8 x 8 pixels, each in Z order;
/// - shadow: light after light, for each the tiles (in that order) that are its turn, so that there
///   are about as many as primary ones; only from where the light is not behind the surface;
/// - scattered: one from every hit, in random order.
/// Directions have length 1, without which the cones of Embree 3 are hit at wrong places. Equal for
/// equal seeds. Empty when nothing is hit, or (shadow) nothing is lit.
BenchBatch record_bench_rays(const World& world, BenchKind kind, std::size_t count,
                             std::uint64_t seed);

}  // namespace bspview
