#pragma once

#include <string>
#include <vector>

#include "core/bsp/build.h"

namespace bspview::test {

/// `params` for every builder, with and without clipping.
std::vector<BuildParams> every_way(BuildParams params = {});

/// Builder and clipping, for messages.
std::string describe(const BuildParams& params);

/// Builds the tree and checks it.
void expect_valid(const BuildInput& input, const BuildParams& params);

/// Same nodes and references in the same order.
void expect_same(const Tree& a, const Tree& b);

}  // namespace bspview::test
