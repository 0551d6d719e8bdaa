#pragma once

#include <functional>
#include <span>
#include <stop_token>

#include "core/base/result.h"
#include "core/bsp/tree.h"

namespace bspview {

/// Box of the part of object `object` inside `cell`, rounded outwards; empty when there is none.
using ClipFunction = std::function<Aabb(std::uint32_t object, const Aabb& cell)>;

/// What a builder knows of the objects.
struct BuildInput {
  std::span<const Aabb> boxes;  ///< one an object; an empty box: the object is in no leaf
  ClipFunction clip;            ///< called from several threads
};

/// Builds a tree. The result does not depend on params.threads. Fails, with the error "stopped",
/// only when `stop` was requested.
Result<Tree> build_tree(const BuildInput& input, const BuildParams& params,
                        std::stop_token stop = {});

}  // namespace bspview
