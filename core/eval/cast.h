#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/bsp/traversal.h"
#include "core/eval/ray_set.h"
#include "core/render/world.h"

namespace bspview {

/// What is asked of every ray of a set.
struct CastParams {
  enum class Query { closest, any };
  Query query = Query::closest;
  Traversal traversal = Traversal::robust;
  int threads = 0;  ///< 0: every core; never changes the results
};

/// Traces the rays; one result a ray, in their order. For Query::any, t is 0 for every
/// hit. With an accelerator, the robust traversal takes neighbours that run the same way together
/// (core/render/hits.h). `progress`, when set, is told how many more rays are done, from several
/// threads.
std::vector<RayResult> cast_rays(const World& world, std::span<const Ray> rays,
                                 const CastParams& params,
                                 const std::function<void(std::size_t)>& progress = {});

/// How cast_rays traces, for people.
std::string cast_kernel(const World& world, const CastParams& params);

}  // namespace bspview
