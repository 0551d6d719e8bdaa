#pragma once

#include <string>
#include <vector>

#include "core/eval/error/pool.h"
#include "core/eval/image_error.h"

namespace bspview {

/// Curves of the picture of one scene.
struct SceneImageError {
  std::string scene;
  ImageErrorParams params;
  std::vector<ImageErrorCurve> curves;
};

/// Everything that one run of the benchmark found.
struct ErrorStudy {
  ErrorReport rays;
  std::vector<SceneImageError> images;
};

/// Tables for the terminal; ends with verdict().
std::string to_text(const ErrorStudy& study);

/// One line a configuration and pool of scenes (each scene, all, those of triangles).
std::string to_csv(const ErrorStudy& study);

/// Everything, as one object.
std::string to_json(const ErrorStudy& study);

/// A page that needs nothing else: plots, tables, how it was measured.
std::string to_html(const ErrorStudy& study);

/// What to do, in one sentence of figures.
std::string verdict(const ErrorStudy& study);

/// "12.3", "< 0.94" for a bound.
std::string format_estimate(const std::optional<Estimate>& estimate);

}  // namespace bspview
