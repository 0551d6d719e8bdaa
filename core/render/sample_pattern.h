#pragma once

#include <vector>

#include "core/math/vec.h"

namespace bspview {

/// Where the first `count` samples of a pixel lie in it, in [0, 1) x [0, 1): the centre first, then
/// so that any number of samples is spread evenly. The first 2^k samples are one in each cell of
/// every grid of 2^k equal cells, and so is each further group of 2^k. A longer pattern begins with
/// the shorter one.
std::vector<Vec2> sample_pattern(int count);

}  // namespace bspview
