#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/viewer/overlays/layer.h"
#include "app/viewer/overlays/node_cells.h"
#include "app/viewer/state.h"
#include "core/bsp/stats.h"
#include "core/eval/lambda.h"
#include "core/eval/pixel_faults.h"
#include "core/eval/trade_offs.h"
#include "core/render/render.h"
#include "core/scene/scene.h"

namespace bspview {

// What the stages are asked for and what they answer. A request holds the results it starts from,
// so that a new scene makes a new tree request, that a new picture request, and so on.

struct SceneRequest {
  std::string source;
  int attempt = 0;
  bool operator==(const SceneRequest&) const = default;
};
struct LoadedScene {
  std::string source;
  Scene scene;
  ObjectCounts counts;
  Aabb bounds;
};

struct TreeRequest {
  std::shared_ptr<const LoadedScene> scene;
  BuildParams params;
  bool operator==(const TreeRequest&) const = default;
};
struct BuiltTree {
  /// cut: from a larger tree; its seconds are no T_CB. sketch: about the tree that is asked for, by
  /// a builder that is sooner done (see `request`), until that one is there.
  enum class Origin { build, cut, sketch };

  /// Without use when a stop is requested while it is made.
  BuiltTree(const TreeRequest& of, std::shared_ptr<const Tree> made, Origin from,
            const std::stop_token& stop);
  TreeRequest request;
  std::shared_ptr<const Tree> shared;
  const Tree& tree;
  Origin origin;
  TreeStats stats;
  NodeCells cells;  // of `tree`

  World world() const { return {request.scene->scene, tree}; }
  /// With an accelerator, which the first call makes: pictures of many samples need it, slider
  /// moves do not. Where that is stopped, or memory is short, without.
  World fast_world(std::stop_token stop) const;

 private:
  mutable std::mutex accelerating_;
  mutable std::shared_ptr<const Accelerator> accelerator_;
};

struct PictureRequest {
  std::shared_ptr<const BuiltTree> tree;
  Camera camera;
  RenderParams params;
  bool operator==(const PictureRequest&) const = default;
};
/// Where the rays through the pixel centres ended; row-major, top row first. See Frame.
struct FirstHits {
  std::vector<float> distance;
  std::vector<std::uint32_t> object, leaf;
};
struct Picture {
  PictureRequest request;
  std::shared_ptr<const std::vector<std::uint32_t>> pixels;  ///< RGBA8, red in the lowest byte
  int pixels_pass = 0;        ///< the pass they are of; more than `pass` when kept from before
  bool pixels_final = false;  ///< no later pass will change them
  std::shared_ptr<const FirstHits> first_hits;
  int pass = 0, pass_count = 0;
  RayCounts counts;
  bool counted = false;

  bool converged() const { return pass == pass_count; }
};

struct PathRequest {
  std::shared_ptr<const BuiltTree> tree;
  RenderParams params;
  Pick pick;
  bool operator==(const PathRequest&) const = default;
};
struct PixelRays {
  PathRequest request;
  std::vector<PathRay> rays;
};

/// What of the picture is wrong, and what other ways of tracing would make of its rays.
struct AccuracyRequest {
  std::shared_ptr<const BuiltTree> tree;
  Camera camera;
  RenderParams params;
  bool operator==(const AccuracyRequest&) const = default;
};
struct Accuracy {
  AccuracyRequest request;
  PixelFaults faults;
  std::vector<TradeOffPoint> points;  ///< empty until the pixels are checked
};

struct OverlayRequest {
  std::shared_ptr<const BuiltTree> tree;
  std::shared_ptr<const FirstHits> first_hits;
  Camera camera;
  int width = 0, height = 0;
  std::optional<BoxView> boxes;
  std::shared_ptr<const PixelRays> rays;     ///< nullptr: no path
  std::shared_ptr<const Accuracy> accuracy;  ///< nullptr: no marks
  bool path_visible = false;
  RaySelection selection;
  float line_width = 1.0f;  ///< pixels
  bool moving = false;      ///< thin the boxes out to a time budget
  bool operator==(const OverlayRequest&) const = default;
};
struct Overlay {
  OverlayRequest request;
  Layer layer;
  std::size_t lines = 0;
};

struct MeasureRequest {
  std::shared_ptr<const BuiltTree> tree;
  Camera camera;
  RenderParams params;
  bool operator==(const MeasureRequest&) const = default;
};
struct Measures {
  MeasureRequest request;
  Lambda lambda;
};

}  // namespace bspview
