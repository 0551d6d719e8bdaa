#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/math/ray.h"
#include "core/render/world.h"

namespace bspview {

/// Where the rays of a measurement come from.
enum class RayGroup {
  primary,    ///< of the scene's picture
  shadow,     ///< of the picture: only asked whether they hit anything
  reflected,  ///< of the picture
  refracted,  ///< of the picture
  scattered,  ///< from every primary hit in a random direction, in random order
  edge,       ///< aimed at random points of edges, in scenes of triangles
  vertex      ///< aimed at vertices, in scenes of triangles
};
inline constexpr std::size_t ray_group_count = 7;
inline bool is_aimed(RayGroup group) {
  return group == RayGroup::edge || group == RayGroup::vertex;
}

/// Names for people and files, in the order of the enumerators.
std::span<const std::string_view> ray_group_names();
std::string_view name_of(RayGroup group);

/// Rays of one kind, the same bits for whoever traces them.
struct RayBatch {
  RayGroup group = RayGroup::primary;
  std::vector<Ray> rays;
};

struct RecordParams {
  std::size_t rays = 1;  ///< about as many primary rays; at most as many of every other group
  int threads = 0;       ///< 0: every core
  std::uint64_t seed = 0;
};

/// The rays of a picture of the scene, made by the default tests, and those that are aimed. Groups
/// without a ray are left out. The same for equal seeds. Fails only when a stop was requested.
Result<std::vector<RayBatch>> record_batches(const World& world, const RecordParams& params,
                                             const Watch& watch = {});

/// Whether edge- and vertex-aimed rays exist for the scene: every object is a triangle.
bool has_only_triangles(const Scene& scene);

}  // namespace bspview
