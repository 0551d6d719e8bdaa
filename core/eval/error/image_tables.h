#pragma once

#include <string>
#include <vector>

#include "core/eval/error/report.h"

namespace bspview {

struct ImageTable {
  std::string title, caption;  ///< the caption says what the columns are
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;
};

/// What was measured of one scene's picture: a table each for uniform sampling, for adaptive
/// sampling and for cut-offs, both set against uniform sampling.
std::vector<ImageTable> image_tables(const SceneImageError& image);

/// "128 x 128 pixels, against 1024 samples a pixel; median of ..."
std::string how_measured(const ImageErrorParams& params);

}  // namespace bspview
