#pragma once

// The rays of a picture: in which tiles, through which points, after which rules.

#include <functional>
#include <stop_token>

#include "core/base/parallel.h"
#include "core/render/sample_pattern.h"
#include "core/render/shade.h"
#include "core/render/tracer.h"

namespace bspview {

inline constexpr int tile_size = 16;  ///< pixels; the stop token is read once a tile

struct Tile {
  int x0, y0, x1, y1;  ///< pixels x0 <= x < x1, y0 <= y < y1
};

/// Calls body(x, y) for the pixels of a tile, row after row.
template <class Body>
void for_each_pixel(const Tile& tile, const Body& body) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) body(x, y);
  }
}

/// The ray through a pixel's sample. See sample_pattern.h.
inline Ray sample_ray(const PrimaryRays& eye, int x, int y, Vec2 offset) {
  return eye.ray(static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y);
}

/// Runs body(tile, index) for every tile of a picture, in parallel; tiles are skipped once `stop`
/// is requested.
void for_each_tile(int width, int height, std::stop_token stop,
                   const std::function<void(const Tile&, int)>& body);
int tile_count(int width, int height);

/// Whether pixels may end with fewer samples than others.
inline bool is_adaptive(const RenderParams& params) {
  return params.adaptive > 0.0f && !params.spd_rules;
}

inline TraceRules trace_rules(const RenderParams& params) {
  TraceRules rules{.traversal = params.traversal, .arithmetic = params.arithmetic};
  if (params.spd_rules) {
    rules.sides = SideRule::opaque_one_sided;
    rules.shadow_sides = SideRule::one_sided;
  }
  return rules;
}

}  // namespace bspview
