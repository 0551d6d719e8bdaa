#pragma once

#include "core/bsp/tree.h"

namespace bspview::test {

/// A tree over the unit cube with `leaves` leaves, each split somewhere in the middle half of its
/// longest side; leaves hold 0 to 7 made-up objects. Only for what needs no objects.
Tree make_random_tree(int leaves, unsigned seed);

}  // namespace bspview::test
