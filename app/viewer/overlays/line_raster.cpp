#include "app/viewer/overlays/line_raster.h"

#include <algorithm>
#include <limits>

#include "app/viewer/overlays/line_bins.h"
#include "app/viewer/overlays/rgba.h"
#include "core/base/check.h"
#include "core/base/parallel.h"

namespace bspview {
namespace {

constexpr std::size_t lines_in_bins = 4096;  // lines that are projected and sorted as one task
constexpr float pixels_behind = 4.0f;  // depth in pixel sides up to which surfaces hide nothing

struct PixelRange {
  int first, end;
};

struct TilePixels {
  PixelRange columns, rows;
};

TilePixels pixels_of(const TileGrid& grid, int tile) {
  const auto range = [](int i, int size) {
    const int first = i * TileGrid::tile_size;
    return PixelRange{first, std::min(first + TileGrid::tile_size, size)};
  };
  return {range(tile % grid.columns(), grid.width), range(tile / grid.columns(), grid.height)};
}

/// The pixels whose interval of length 1 meets [lo, hi], cut to `range`.
PixelRange pixels_between(float lo, float hi, PixelRange range) {
  const auto first = static_cast<float>(range.first), end = static_cast<float>(range.end);
  return {static_cast<int>(std::clamp(lo, first, end)),
          std::min(static_cast<int>(std::clamp(hi, first - 1.0f, end)) + 1, range.end)};
}

/// Length of the part of pixel `i`'s interval that lies in [lo, hi].
float overlap(float lo, float hi, int i) {
  const auto start = static_cast<float>(i);
  return std::min(hi, start + 1.0f) - std::max(lo, start);
}

class TilePainter {
 public:
  TilePainter(Layer& layer, const LineView& view, float pixel_size)
      : layer_(layer), view_(view), visible_from_(1.0f - pixels_behind * pixel_size) {}

  void draw(const ScreenLine& line, const TilePixels& tile) const {
    if (line.steep) {
      draw_along<true>(line, tile.rows, tile.columns);
    } else {
      draw_along<false>(line, tile.columns, tile.rows);
    }
  }

 private:
  /// A pixel's opacity is the share of it that the line covers, along the minor axis at the
  /// pixel's middle. It depends on line and pixel alone, so tiles leave no seams.
  template <bool steep>
  void draw_along(const ScreenLine& line, PixelRange majors, PixelRange minors) const {
    const auto alpha = static_cast<float>(line.color >> 24);
    const PixelRange range = pixels_between(line.first, line.last, majors);
    for (int i = range.first; i < range.end; ++i) {
      const float major = std::clamp(static_cast<float>(i) + 0.5f, line.first, line.last);
      const float minor = line.minor_at(major);
      const float lo = minor - line.half_thickness, hi = minor + line.half_thickness;
      const PixelRange across = pixels_between(lo, hi, minors);
      if (across.first >= across.end) continue;
      const bool hidden = is_hidden<steep>(i, minor, line.inverse_depth_at(major));
      const float ink =
          alpha * overlap(line.first, line.last, i) * (hidden ? view_.hidden_alpha : 1.0f);
      for (int j = across.first; j < across.end; ++j) {
        mix(layer_.pixels[index<steep>(i, j)], line.color, ink * overlap(lo, hi, j));
      }
    }
  }

  template <bool steep>
  std::size_t index(int major, int minor) const {
    const int row = steep ? major : minor, column = steep ? minor : major;
    return static_cast<std::size_t>(row) * layer_.width + column;
  }

  /// Behind the surface in the pixel that holds (i, minor) and in both its neighbours across the
  /// line: on a slanted surface one of them is behind the line, however flat it is seen.
  template <bool steep>
  bool is_hidden(int i, float minor, float inverse_depth) const {
    if (view_.distance.empty()) return false;
    const int last = (steep ? layer_.width : layer_.height) - 1;
    const int j = static_cast<int>(std::clamp(minor, 0.0f, static_cast<float>(last)));
    const auto is_behind = [&](int k) {
      return view_.distance[index<steep>(i, k)] * inverse_depth < visible_from_;
    };
    return is_behind(j) && is_behind(std::max(j - 1, 0)) && is_behind(std::min(j + 1, last));
  }

  /// The more opaque colour stays; `alpha` in [0, 255].
  static void mix(std::uint32_t& pixel, std::uint32_t color, float alpha) {
    const auto opacity = static_cast<std::uint32_t>(std::max(alpha, 0.0f) + 0.5f);
    if (opacity == 0 || opacity < pixel >> 24) return;
    pixel = scale_color(color | 0xff000000u, opacity);
  }

  Layer& layer_;
  const LineView& view_;
  float visible_from_;  // least distance / depth at which a line is in front of the surface
};

std::vector<LineBins> sort_into_bins(std::span<const Line> lines, const ScreenTransform& transform,
                                     const TileGrid& grid, const std::stop_token& stop) {
  std::vector<LineBins> bins((lines.size() + lines_in_bins - 1) / lines_in_bins);
  parallel_for(static_cast<int>(bins.size()), [&](int i) {
    if (stop.stop_requested()) return;
    const std::size_t first = i * lines_in_bins;
    const std::size_t count = std::min(lines_in_bins, lines.size() - first);
    bins[i] = LineBins(lines.subspan(first, count), transform, grid);
  });
  return bins;
}

}  // namespace

std::optional<Layer> draw_lines(std::span<const Line> lines, const LineView& view,
                                std::stop_token stop) {
  Layer layer(view.width, view.height);
  BSPVIEW_CHECK(view.distance.empty() || view.distance.size() == layer.pixels.size());
  if (layer.pixels.empty()) return layer;
  const ScreenTransform transform(view.camera, view.width, view.height);
  const TileGrid grid{view.width, view.height};
  const TilePainter painter(layer, view, transform.pixel_size());
  with_threads(view.threads, [&] {
    const std::vector<LineBins> bins = sort_into_bins(lines, transform, grid, stop);
    parallel_for(grid.count(), [&](int tile) {
      if (stop.stop_requested()) return;
      const TilePixels pixels = pixels_of(grid, tile);
      for (const LineBins& bin : bins) {
        for (const std::uint32_t i : bin.in_tile(tile)) painter.draw(bin.line(i), pixels);
      }
    });
  });
  if (stop.stop_requested()) return {};
  return layer;
}

}  // namespace bspview
