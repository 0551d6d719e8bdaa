#pragma once

namespace bspview {

/// Pixels.
struct PictureSize {
  int width = 1, height = 1;
  bool operator==(const PictureSize&) const = default;
};

}  // namespace bspview
