#pragma once

#include "core/base/result.h"
#include "core/bsp/build.h"

namespace bspview {

/// Checks that the children tile their parent, that every reference is an object, that every
/// object is in every leaf it touches (by its box, or by `input.clip` where the tree was built
/// with clipping), and that depth and counts are within what was asked for. O(leaves x log) when
/// the tree is good; the error names the first node that is not.
Result<void> validate(const Tree& tree, const BuildInput& input);

}  // namespace bspview
