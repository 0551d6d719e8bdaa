#include "app/viewer/overlays/line_raster.h"

#include <algorithm>

#include "app/viewer/overlays/line_bins.h"
#include "app/viewer/overlays/tile_canvas.h"
#include "core/base/check.h"
#include "core/base/parallel.h"

namespace bspview {
namespace {

constexpr std::size_t lines_in_bins = 4096;  // lines that are projected and sorted as one task
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

bool is_empty(const std::vector<LineBins>& bins, int tile) {
  return std::all_of(bins.begin(), bins.end(),
                     [&](const LineBins& bin) { return bin.in_tile(tile).empty(); });
}

}  // namespace

std::optional<Layer> draw_lines(std::span<const Line> lines, const LineView& view,
                                std::stop_token stop) {
  Layer layer(view.width, view.height);
  BSPVIEW_CHECK(view.distance.empty() || view.distance.size() == layer.pixels.size());
  if (layer.pixels.empty()) return layer;
  const ScreenTransform transform(view.camera, view.width, view.height);
  const TileGrid grid{view.width, view.height};
  with_threads(view.threads, [&] {
    const std::vector<LineBins> bins = sort_into_bins(lines, transform, grid, stop);
    parallel_for(grid.count(), [&](int tile) {
      if (stop.stop_requested() || is_empty(bins, tile)) return;
      TileCanvas canvas(view, grid, tile, transform.pixel_size());
      for (const LineBins& bin : bins) {
        for (const std::uint32_t i : bin.in_tile(tile)) canvas.draw(bin.line(i));
      }
      canvas.store(layer);
    });
  });
  if (stop.stop_requested()) return {};
  return layer;
}

}  // namespace bspview
