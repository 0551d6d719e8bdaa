#include "core/bsp/tree.h"

#include <algorithm>
#include <cmath>

namespace bspview {

int automatic_depth(std::size_t objects) {
  if (objects < 2) return 8;
  return std::min(depth_cap, static_cast<int>(
                                 std::lround(8.0 + 1.3 * std::log2(static_cast<double>(objects)))));
}

int effective_depth(const BuildParams& params, std::size_t objects) {
  return std::clamp(params.max_depth.value_or(automatic_depth(objects)), 0, depth_cap);
}

bool effective_clip(const BuildParams& params) {
  return params.clip.value_or(params.builder != Builder::median);
}

}  // namespace bspview
