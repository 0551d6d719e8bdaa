#pragma once

#include <memory>
#include <optional>

#include "app/viewer/evaluation.h"
#include "app/viewer/requests.h"
#include "core/base/result.h"

namespace bspview {

/// What the stages have to show in this frame. Anything may be missing.
struct Results {
  std::shared_ptr<const LoadedScene> scene;
  std::shared_ptr<const BuiltTree> tree;
  std::shared_ptr<const Picture> picture;
  std::shared_ptr<const PixelRays> rays;
  std::shared_ptr<const Overlay> overlay;
  std::shared_ptr<const Accuracy> accuracy;
  std::optional<Evaluation> now, before;
  std::optional<Error> scene_error, tree_error;
  bool scene_busy = false, tree_busy = false, picture_busy = false, measures_busy = false,
       accuracy_busy = false;
  double tree_progress = 0.0;  ///< share of the tree under way that is built
};

}  // namespace bspview
