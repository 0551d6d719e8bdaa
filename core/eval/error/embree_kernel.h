#pragma once

#include <vector>

#include "core/eval/error/config.h"

namespace bspview {

/// Embree (Wald et al. 2014, "Embree: A Kernel Framework for Efficient CPU Ray Tracing") in its
/// default and its robust mode, single rays, for scenes of triangles only. None where the build
/// found no libembree-dev.
std::vector<ErrorConfig> embree_configs();

}  // namespace bspview
