#pragma once

#include <memory>
#include <span>

#include "core/bsp/tree.h"
#include "core/render/lazy_part.h"

namespace bspview {

/// `top` with the trees of its parts, and of theirs, in the place of the leaves that they were;
/// `parts` comes in the order of top.unbuilt.
Tree graft_parts(const Tree& top, std::span<const std::shared_ptr<const LazyPart>> parts);

}  // namespace bspview
