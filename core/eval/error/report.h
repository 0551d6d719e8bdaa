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

/// Everything that one run of the benchmark found; without scenes or images: not measured.
struct ErrorStudy {
  ErrorReport rays;
  std::vector<SceneImageError> images;
};

/// Tables for the terminal; ends with the sentences of verdict().
std::string to_text(const ErrorStudy& study);

/// One line a configuration and pool of scenes (each scene, all, those of triangles).
std::string to_csv(const ErrorReport& report);

/// One line a picture.
std::string to_csv(std::span<const SceneImageError> images);

/// Everything, as one object.
std::string to_json(const ErrorStudy& study);

/// A page that needs nothing else: plots, tables, how it was measured.
std::string to_html(const ErrorStudy& study);

/// What to do, in sentences of figures: one about rays, two a picture.
std::vector<std::string> verdict(const ErrorStudy& study);

/// A sentence where Embree was not there when this was built; else empty.
std::string embree_sentence(const ErrorReport& report);

/// "processor time of one thread", "wall-clock time of 4 threads"
std::string clock_text(int timing_threads);

/// "12.3", "< 0.94" for a bound.
std::string format_estimate(const std::optional<Estimate>& estimate);

}  // namespace bspview
