#pragma once

// The rays of a picture: in which tiles, through which points, after which rules.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/base/parallel.h"
#include "core/render/sample_pattern.h"
#include "core/render/shade.h"
#include "core/render/tracer.h"
#include "core/render/z_order.h"

namespace bspview {

inline constexpr int tile_size = 16;  ///< pixels; the stop token is read once a tile

struct Tile {
  int x0, y0, x1, y1;  ///< pixels x0 <= x < x1, y0 <= y < y1
};

/// Calls body(x, y) for the pixels of a tile in Z order, so that as many as are traced at once lie
/// close together.
template <class Body>
void for_each_pixel(const Tile& tile, const Body& body) {
  for (std::uint32_t i = 0; i < tile_size * tile_size; ++i) {
    const GridPlace place = z_order(i);
    const int x = tile.x0 + place.x, y = tile.y0 + place.y;
    if (x < tile.x1 && y < tile.y1) body(x, y);
  }
}

/// The eye rays through one sample of some pixels, to be traced together.
class EyeRays {
 public:
  void clear() {
    rays_.clear();
    pixels_.clear();
  }
  void add(std::size_t pixel, const Ray& ray) {
    rays_.push_back(ray);
    pixels_.push_back(pixel);
  }

  /// Calls done(pixel, colour) for each.
  template <class Tracer, class Done>
  void shade(Shader<Tracer>& shader, const Done& done) {
    hits_.resize(rays_.size());
    colors_.resize(rays_.size());
    shader.trace(rays_, hits_, colors_);
    for (std::size_t i = 0; i < rays_.size(); ++i) done(pixels_[i], colors_[i]);
  }

 private:
  std::vector<Ray> rays_;
  std::vector<std::size_t> pixels_;
  std::vector<Hit> hits_;
  std::vector<Vec3> colors_;
};

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
