// After Purgathofer 1987, "A statistical method for adaptive stochastic sampling", with the
// convergence of stratified samples (Mitchell 1996, "Consequences of stratified sampling in
// graphics").
#include "core/render/adaptive.h"

#include <algorithm>
#include <cmath>

#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

float shown(float value) {
  return value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // a NaN becomes 0
}

}  // namespace

PixelSamples::PixelSamples(int width, int height, float threshold)
    : width_(width), height_(height), threshold_(threshold) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  sums_.assign(pixels, Vec3(0.0f));
  counts_.assign(pixels, 0);
  alive_.assign(pixels, 1);
  tile_alive_.assign(static_cast<std::size_t>(tile_count(width, height)), 1);
  if (threshold <= 0.0f) return;
  squares_.assign(pixels, Vec3(0.0f));
  errors_.assign(pixels, 0.0f);
}

void PixelSamples::add(std::size_t pixel, Vec3 color) {
  if (threshold_ > 0.0f && counts_[pixel] > 0) {
    const float count = static_cast<float>(counts_[pixel]);
    const Vec3 away = color - sums_[pixel] / count;
    squares_[pixel] += count / (count + 1.0f) * away * away;
  }
  sums_[pixel] += color;
  ++counts_[pixel];
}

std::vector<Vec3> PixelSamples::means() && {
  for (std::size_t pixel = 0; pixel < sums_.size(); ++pixel) sums_[pixel] = mean(pixel);
  return std::move(sums_);
}

bool PixelSamples::any_lives() const {
  return std::ranges::find(tile_alive_, 1) != tile_alive_.end();
}

void PixelSamples::judge(std::stop_token stop) {
  if (threshold_ <= 0.0f) return;
  for_each_tile(width_, height_, stop, [&](const Tile& tile, int number) {
    if (!any_lives_in(number)) return;
    for_each_pixel(tile, [&](int x, int y) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width_ + x;
      if (lives(pixel)) errors_[pixel] = error(pixel);
    });
  });
  for_each_tile(width_, height_, stop, [&](const Tile& tile, int number) {
    if (!any_lives_in(number)) return;
    char any = 0;
    for_each_pixel(tile, [&](int x, int y) {
      char& alive = alive_[static_cast<std::size_t>(y) * width_ + x];
      if (alive != 0 && !is_in_doubt(x, y)) alive = 0;
      any |= alive;
    });
    tile_alive_[static_cast<std::size_t>(number)] = any;
  });
}

float PixelSamples::error(std::size_t pixel) const {
  const float count = static_cast<float>(counts_[pixel]);
  const float spread = 1.0f / (std::sqrt(count - 1.0f) * std::pow(count, 0.75f));
  const Vec3 middle = mean(pixel);
  float largest = 0.0f;
  for (int channel = 0; channel < 3; ++channel) {
    const float off = std::sqrt(squares_[pixel][channel]) * spread;
    const float change = shown(middle[channel] + off) - shown(middle[channel] - off);
    largest = std::max(largest, 0.5f * change);
  }
  return largest;
}

/// Whether the error of the pixel or of a neighbour is not below the threshold.
bool PixelSamples::is_in_doubt(int x, int y) const {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height_ - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width_ - 1); ++u) {
      if (errors_[static_cast<std::size_t>(v) * width_ + u] >= threshold_) return true;
    }
  }
  return false;
}

}  // namespace bspview
