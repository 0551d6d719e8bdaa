#pragma once

#include "app/viewer/overlays/layer.h"
#include "core/eval/pixel_faults.h"

namespace bspview {

/// RGBA of a fault; 0 for what is none.
[[nodiscard]] std::uint32_t fault_color(PixelFault fault);

/// A mark of 3 x 3 pixels for every fault, its form telling the kind too: + lost, x phantom, a
/// square for a self-hit.
[[nodiscard]] Layer fault_marks(const PixelFaults& faults);

}  // namespace bspview
