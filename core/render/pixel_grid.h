#pragma once

// The rays of a picture: which pixels, where in them, in which tiles.

#include <functional>
#include <stop_token>

#include "core/base/parallel.h"
#include "core/render/shade.h"
#include "core/render/tracer.h"

namespace bspview {

inline constexpr int tile_size = 16;  ///< pixels; the stop token is read once a tile

/// Where sample number `sample` lies in its pixel: the centre first, then the R2 sequence (Roberts
/// 2018), which fills the pixel evenly for any number of samples.
inline Vec2 sample_offset(int sample) {
  const auto fraction = [](double x) { return static_cast<float>(x - std::floor(x)); };
  return {fraction(0.5 + sample * 0.7548776662466927), fraction(0.5 + sample * 0.5698402909980532)};
}

struct Tile {
  int x0, y0, x1, y1;  ///< pixels x0 <= x < x1, y0 <= y < y1
};

/// Runs body(tile, index) for every tile of a picture, in parallel; tiles are skipped once `stop`
/// is requested.
void for_each_tile(int width, int height, std::stop_token stop,
                   const std::function<void(const Tile&, int)>& body);
int tile_count(int width, int height);

inline TraceRules trace_rules(const RenderParams& params) {
  if (!params.spd_rules) return {.traversal = params.traversal};
  return {params.traversal, SideRule::opaque_one_sided, SideRule::one_sided};
}

}  // namespace bspview
