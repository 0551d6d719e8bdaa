#include "app/viewer/overlays/tile_canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/viewer/overlays/rgba.h"

namespace bspview {
namespace {

constexpr int size = TileCanvas::size, border = TileCanvas::border, stride = TileCanvas::stride;
static_assert(border >= max_line_width * 1.4143f + 1.0f, "a line beside the tile must fit in it");
constexpr float pixels_behind = 2.0f;  // depth, in pixel sides, up to which a surface hides nothing

/// The tile's first pixel on both axes of a line.
struct Corner {
  int major, minor;
};

/// An interval of pixels of the tile, first and last included; empty when first > last.
struct PixelRange {
  int first, last;
};

/// The pixels of the tile's major axis along which `line` may touch it.
PixelRange pixels_inside(const ScreenLine& line, Corner corner) {
  const auto lowest = static_cast<float>(corner.major);
  const float reach = line.half_thickness + 0.5f;
  const float below = static_cast<float>(corner.minor) - reach - line.minor;
  const float above = below + size + 2.0f * reach;
  // A line along the major axis divides by 0: infinities, or a NaN, which max and min pass over.
  const float a = line.first + below / line.slope, b = line.first + above / line.slope;
  const float enter = std::max(std::max(line.first, lowest), std::min(a, b));
  const float leave = std::min(std::min(line.last, lowest + size - 0.5f), std::max(a, b));
  if (!(enter <= leave)) return {0, -1};
  return {static_cast<int>(enter), static_cast<int>(leave)};
}

constexpr int step_count = 16;

/// A line's cross-section and colour.
struct Stroke {
  Stroke(const ScreenLine& line, float hidden_factor)
      : thickness(2.0f * line.half_thickness),
        across(static_cast<int>(std::ceil(thickness)) + 1),
        alpha(static_cast<float>(line.color >> 24)),
        hidden_alpha(hidden_factor * alpha),
        rgb(line.color & 0x00ffffffu) {}

  float thickness;  // in pixels along the minor axis
  int across;       // pixels that it may touch
  float alpha, hidden_alpha;
  std::uint32_t rgb;
};

/// Pixels in a row along the major axis.
struct Steps {
  std::array<int, step_count> pixel;  // index of the first pixel across
  std::array<float, step_count> lo;   // where the line begins in it
  std::array<float, step_count> inverse_depth;
  std::array<float, step_count> ink;  // greatest opacity
};

/// Sixteen steps of `line` from pixel `first` of the major axis on, along which `along` leads from
/// one pixel of the canvas to the next, and `aside` across.
template <int along, int aside>
Steps make_steps(const ScreenLine& line, const Stroke& stroke, Corner corner, int first) {
  const float edge = line.minor - line.half_thickness + static_cast<float>(border - corner.minor);
  const auto highest = static_cast<float>(stride - stroke.across);
  Steps steps;
  for (int i = 0; i < step_count; ++i) {
    const auto x = static_cast<float>(first + i);
    const float from_first = x + 0.5f - line.first;
    const float lo = std::min(std::max(edge + line.slope * from_first, 0.0f), highest);
    const int row = static_cast<int>(lo);
    steps.pixel[i] = (first + i - corner.major + border) * along + row * aside;
    steps.lo[i] = lo - static_cast<float>(row);
    steps.inverse_depth[i] = line.inverse_depth + line.inverse_depth_slope * from_first;
    steps.ink[i] = std::max(std::min(line.last, x + 1.0f) - std::max(line.first, x), 0.0f);
  }
  return steps;
}

/// What the line leaves in the `k`-th pixel across.
std::array<std::uint32_t, step_count> colors_of_row(const Steps& steps, const Stroke& stroke,
                                                    int k) {
  std::array<std::uint32_t, step_count> colors;
  const auto start = static_cast<float>(k);
  for (int i = 0; i < step_count; ++i) {
    const float lo = steps.lo[i], hi = lo + stroke.thickness;
    const float covered = std::max(std::min(hi, start + 1.0f) - std::max(lo, start), 0.0f);
    const float rounded = 0.5f + steps.ink[i] * covered;  // lround is no vector instruction
    colors[i] = static_cast<std::uint32_t>(static_cast<int>(rounded)) << 24 | stroke.rgb;
  }
  return colors;
}

/// The more opaque colour, `ours` among equals. With a mask, since no branch could be predicted.
std::uint32_t more_opaque(std::uint32_t ours, std::uint32_t theirs) {
  const std::uint32_t mask = 0u - static_cast<std::uint32_t>((ours | 0x00ffffffu) >= theirs);
  return theirs ^ ((ours ^ theirs) & mask);
}

}  // namespace

TileCanvas::TileCanvas(const LineView& view, const TileGrid& grid, int tile, float pixel_size)
    : column_(tile % grid.columns() * size),
      row_(tile / grid.columns() * size),
      visible_from_(1.0f - pixels_behind * pixel_size),
      hidden_alpha_(view.hidden_alpha) {
  farthest_.fill(std::numeric_limits<float>::infinity());
  if (!view.distance.empty()) load_distances(view);
}

/// On a slanted surface, however flat it is seen, one of the neighbours of a line's pixel is behind
/// the line.
void TileCanvas::load_distances(const LineView& view) {
  const int bottom = std::min(row_ + size, view.height);
  const int left = std::max(column_ - 1, 0), right = std::min(column_ + size, view.width - 1);
  const auto row = [&](int y) {
    const int inside = std::clamp(y, 0, view.height - 1);
    return view.distance.data() + static_cast<std::ptrdiff_t>(inside) * view.width;
  };
  // One pixel more on both sides, nothing there beside the picture.
  std::array<float, size + 2> farthest_in_column;
  farthest_in_column.fill(0.0f);
  for (int y = row_; y < bottom; ++y) {
    const float *above = row(y - 1), *here = row(y), *below = row(y + 1);
    for (int x = left; x <= right; ++x) {
      farthest_in_column[x - column_ + 1] = std::max({above[x], here[x], below[x]});
    }
    float* to = &farthest_[(y - row_ + border) * stride + border];
    for (int x = 0; x < size; ++x) {
      const float* around = &farthest_in_column[x];
      to[x] = std::max({around[0], around[1], around[2]});
    }
  }
}

void TileCanvas::draw(const ScreenLine& line) {
  if (line.steep) {
    draw_along<true>(line);
  } else {
    draw_along<false>(line);
  }
}

/// A pixel's opacity is the share of it that the line covers, taken across the line at the pixel's
/// middle. It depends on line and pixel alone, so tiles leave no
/// seams.
///
/// Sixteen steps at a time, in loops that compilers turn into vector instructions and that branch
/// nowhere: no branch here could be predicted. What lies beside the tile goes into its border.
template <bool steep>
void TileCanvas::draw_along(const ScreenLine& line) {
  constexpr int along = steep ? stride : 1, aside = steep ? 1 : stride;
  const Corner corner = steep ? Corner{row_, column_} : Corner{column_, row_};
  const Stroke stroke(line, hidden_alpha_);
  const PixelRange range = pixels_inside(line, corner);
  for (int first = range.first; first <= range.last; first += step_count) {
    Steps steps = make_steps<along, aside>(line, stroke, corner, first);
    const int count = std::min(step_count, range.last - first + 1);
    for (int i = 0; i < count; ++i) {
      const float farthest = farthest_[steps.pixel[i] + stroke.across / 2 * aside];
      const bool hidden = farthest * steps.inverse_depth[i] < visible_from_;
      steps.ink[i] *= hidden ? stroke.hidden_alpha : stroke.alpha;
    }
    for (int k = 0; k < stroke.across; ++k) {
      const auto ours = colors_of_row(steps, stroke, k);
      for (int i = 0; i < count; ++i) {
        std::uint32_t& theirs = pixels_[steps.pixel[i] + k * aside];
        theirs = more_opaque(ours[i], theirs);
      }
    }
  }
}

void TileCanvas::store(Layer& layer) const {
  const int width = std::min(size, layer.width - column_);
  const int height = std::min(size, layer.height - row_);
  for (int y = 0; y < height; ++y) {
    const std::uint32_t* from = &pixels_[(y + border) * stride + border];
    std::uint32_t* to = &layer.pixels[static_cast<std::size_t>(row_ + y) * layer.width + column_];
    for (int x = 0; x < width; ++x) to[x] = premultiply(from[x]);
  }
}

}  // namespace bspview
