#include <utility>

#include "app/viewer/overlays/fault_marks.h"
#include "app/viewer/overlays/leaf_borders.h"
#include "app/viewer/overlays/line_raster.h"
#include "app/viewer/overlays/rgba.h"
#include "app/viewer/overlays/thinning.h"
#include "app/viewer/work.h"
#include "core/base/timer.h"

namespace bspview {
namespace {

constexpr float moving_budget_ms = 20.0f;
constexpr float border_alpha = 0.45f;

LeafMask shown_leaves(const OverlayRequest& request) {
  const BoxView& view = *request.boxes;
  if (view.cells == BoxView::Cells::all) return filter_leaves(request.tree->tree, view.filter);
  std::span<const std::uint32_t> surface;
  if (request.first_hits) surface = request.first_hits->leaf;
  std::span<const PathRay> rays;
  if (request.rays) rays = request.rays->rays;
  return touched_leaves(request.tree->cells, view.filter, surface, rays);
}

LineList box_lines(const OverlayRequest& request, const ScreenTransform& transform,
                   float min_pixels, std::stop_token stop) {
  const BoxView& view = *request.boxes;
  NodeBoxStyle style;
  style.color_by = view.color_by;
  style.width = request.line_width;
  style.scale = leaf_color_scale(request.tree->stats, view.color_by, view.map);
  return node_box_lines(request.tree->tree, shown_leaves(request), style,
                        BoxPruning{transform, min_pixels}, stop);
}

LineList path_lines(const OverlayRequest& request, const ScreenTransform& transform) {
  const RayPathScene world{request.tree->request.scene->scene, request.tree->cells, transform};
  LineList lines = ray_path_lines(world, request.rays->rays, request.selection);
  for (Line& line : lines) line.width *= request.line_width;
  return lines;
}

LineView line_view(const OverlayRequest& request) {
  LineView view;
  view.camera = request.camera;
  view.width = request.width;
  view.height = request.height;
  if (request.first_hits) view.distance = request.first_hits->distance;
  return view;
}

bool borders_wanted(const OverlayRequest& request) {
  return request.boxes && request.boxes->borders && request.first_hits;
}

/// Gives the turn back however the work ends.
class TakenTurn {
 public:
  TakenTurn(OverlayTurn& turn, std::shared_ptr<const FirstHits> hits)
      : turn_(turn), hits_(std::move(hits)) {}
  ~TakenTurn() { turn_.finish(std::move(hits_)); }
  TakenTurn(const TakenTurn&) = delete;
  TakenTurn& operator=(const TakenTurn&) = delete;

 private:
  OverlayTurn& turn_;
  std::shared_ptr<const FirstHits> hits_;
};

}  // namespace

Result<void> OverlayWork::operator()(const OverlayRequest& request, std::stop_token stop,
                                     const Publish<Overlay>& publish) {
  const TakenTurn turn(*turn_, request.first_hits);
  const Timer timer;
  const ScreenTransform transform(request.camera, request.width, request.height);
  LineList lines;
  if (request.boxes)
    lines = box_lines(request, transform, request.moving ? min_pixels_ : 1.0f, stop);
  if (request.rays && request.path_visible) {
    const LineList path = path_lines(request, transform);
    lines.insert(lines.end(), path.begin(), path.end());
  }
  std::optional<Layer> drawn = draw_lines(lines, line_view(request), stop);
  if (!drawn) return Error{"stopped"};
  auto overlay = std::make_shared<Overlay>();
  overlay->request = request;
  overlay->lines = lines.size();
  if (borders_wanted(request)) {
    overlay->layer = leaf_borders(request.first_hits->leaf, request.width, request.height,
                                  pack_color(Vec3(1.0f), border_alpha));
    lay_over(overlay->layer, *drawn);
  } else {
    overlay->layer = *std::move(drawn);
  }
  if (request.accuracy) lay_over(overlay->layer, fault_marks(request.accuracy->faults));
  if (request.moving)
    min_pixels_ =
        next_min_pixels(min_pixels_, 1e3f * static_cast<float>(timer.seconds()), moving_budget_ms);
  publish(std::move(overlay));
  return {};
}

}  // namespace bspview
