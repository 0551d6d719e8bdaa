#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/math/vec.h"

namespace bspview {

/// Pixels are judged after this many samples, and then after as many more.
inline constexpr int judged_samples = 8;

/// The samples of every pixel, and which pixels live: need more of them.
///
/// The mean of n samples is taken to be off by e = s n^(-3/4) in each channel, s being their
/// standard deviation. That is what the samples of sample_pattern.h leave of an edge across the
/// pixel (s n^(-1/2) would be that of random samples). The error of the pixel is what that changes
/// of its colour as it is shown, from 0 to 1: the largest over the channels of
/// (clamp(mean + e) - clamp(mean - e)) / 2. A pixel lives while its error, or that of one of its
/// eight neighbours, is not below the threshold; a pixel that died stays dead.
///
/// The bias: whether a pixel dies depends on its samples, so that pixels whose samples happen to
/// agree stop early, and a detail that the first samples of a pixel and of its neighbours all
/// missed stays unseen. Against uniform sampling with as many samples as a pixel may have, the
/// pictures of the standard scenes are off by less than half the threshold in the mean over pixels,
/// by less than a tenth with signs, by less than the threshold in the root mean square; single
/// pixels, where a thin detail was missed, can be off by more. The smaller the threshold, the fewer
/// pixels die. A pixel that never died has the colour of uniform sampling, bit for bit, and so has
/// every pixel at threshold 0.
class PixelSamples {
 public:
  /// Threshold 0: every pixel lives for ever.
  PixelSamples(int width, int height, float threshold);

  void add(std::size_t pixel, Vec3 color);
  Vec3 mean(std::size_t pixel) const { return sums_[pixel] / static_cast<float>(counts_[pixel]); }
  std::vector<Vec3> means() &&;  ///< of all pixels
  bool lives(std::size_t pixel) const { return alive_[pixel] != 0; }

  /// Whether some pixel lives, of the picture or of a tile (see pixel_grid.h).
  bool any_lives() const;
  bool any_lives_in(int tile) const { return tile_alive_[static_cast<std::size_t>(tile)] != 0; }

  /// Judges the pixels that live, on the threads of the enclosing with_threads; what a stop leaves
  /// undone stays undone. Nothing at threshold 0.
  void judge(std::stop_token stop);

 private:
  float error(std::size_t pixel) const;
  bool is_in_doubt(int x, int y) const;

  int width_, height_;
  float threshold_;
  std::vector<Vec3> sums_;             // of the colours
  std::vector<Vec3> squares_;          // of the distances from the mean, added up; if judged
  std::vector<std::uint32_t> counts_;  // of the samples
  std::vector<float> errors_;          // when last judged; if judged
  std::vector<char> alive_;
  std::vector<char> tile_alive_;  // index: tile
};

}  // namespace bspview
