#pragma once

#include "core/base/result.h"
#include "core/bsp/build.h"

namespace bspview {

/// Checks that the children tile their parent and come behind it, that every node and reference
/// belongs to the tree once, that every object is in every leaf it touches and in no other (by its
/// box; where the tree was built with clipping, by `input.clip`), and that depth and counts are
/// within what was asked for. The error names the first node that is not as it should be.
///
/// Rounding is allowed for: an object that clipping loses anywhere on the way to a leaf need not be
/// in it, and one that is in it may lie off it by 8 ulp of the largest coordinate.
///
/// O(references x depth), without the memory for a second tree.
Result<void> validate(const Tree& tree, const BuildInput& input);

}  // namespace bspview
