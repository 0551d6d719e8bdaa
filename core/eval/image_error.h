#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/eval/lambda.h"
#include "core/render/render.h"

namespace bspview {

/// Root of the mean squared difference over pixels and channels, of the colours as they are shown:
/// clamped to 0 .. 1, a NaN being 0. Both pictures have the same size.
double rmse(const Image& image, const Image& reference);

/// Mean over pixels and channels of (a - r)^2 / (r^2 + 0.01), a and r being clamped as in rmse
/// (Rousselle, Knaus & Zwicker 2011, "Adaptive sampling and reconstruction using greedy error
/// minimization"): errors in the dark weigh more.
double rel_mse(const Image& image, const Image& reference);

/// How far a picture is off another one on average, over pixels and channels, as shown.
struct ImageBias {
  double signed_mean = 0.0;
  double absolute_mean = 0.0;
  double root_mean_square = 0.0;
  bool operator==(const ImageBias&) const = default;
};
ImageBias image_bias(const Image& image, const Image& whole);

/// What the bias of adaptive sampling stays below on the standard scenes, in thresholds. See
/// adaptive.h.
inline constexpr ImageBias adaptive_bias_bound{0.1, 0.5, 1.0};

/// Which pictures of a scene are compared, and how often they are timed.
struct ImageErrorParams {
  RenderParams render;           ///< size, ray depth, traversal, threads; the rest is replaced
  int reference_samples = 1024;  ///< rays a pixel of the converged picture: uniform, no cut-off
  std::vector<int> samples{1, 2, 4, 8, 16, 32, 64};    ///< of uniform sampling
  std::vector<float> thresholds{0.04f, 0.02f, 0.01f};  ///< of adaptive sampling
  int adaptive_samples = 256;                          ///< most rays a pixel there
  std::vector<float> cutoffs{0.002f, 0.01f, 0.05f};  ///< each with uniform sampling; 0 comes anyway
  std::vector<int> cutoff_samples{4, 16, 64};        ///< there
  int repeats = 9;                                   ///< of each picture, interleaved
  int timing_threads = 1;                            ///< as for time_run
};

/// One way to make the picture, what it cost and how wrong it was.
struct ImageErrorPoint {
  std::string name;                ///< "16 samples", "threshold 0.01"
  RenderParams params;             ///< makes this picture
  double samples_per_pixel = 0.0;  ///< mean
  Measured seconds;                ///< its repeats say how often it was timed
  double rmse = 0.0;
  double rel_mse = 0.0;
  /// Against the picture with params.samples in every pixel and every ray shot.
  ImageBias bias;
};

/// Points of one method, from the least to the most samples a pixel.
struct ImageErrorCurve {
  std::string name;  ///< "uniform", "adaptive", "cut-off 0.01"
  std::vector<ImageErrorPoint> points;
};

/// The curves of the picture that `camera` sees: uniform first, then adaptive, then one for each
/// cut-off. Fails, with the error "stopped", only when a stop was requested.
Result<std::vector<ImageErrorCurve>> measure_image_error(const World& world, const Camera& camera,
                                                         const ImageErrorParams& params,
                                                         const Watch& watch = {});

/// Where a curve is between its points, by straight lines in logarithms: the samples a pixel and
/// the seconds that it takes to an error, the error after a time. nullopt beyond its ends.
std::optional<double> samples_for(const ImageErrorCurve& curve, double rmse);
std::optional<double> seconds_for(const ImageErrorCurve& curve, double rmse);
std::optional<double> rmse_after(const ImageErrorCurve& curve, double seconds);

/// A point of one curve against another, the base.
struct ImageErrorMatch {
  std::string name;           ///< of the point
  double rmse = 0.0;          ///< of the point
  double samples = 0.0;       ///< a pixel, of the point
  double base_samples = 0.0;  ///< that the base takes to the same rmse
  double seconds = 0.0;       ///< of the point
  double base_seconds = 0.0;  ///< that the base takes to the same rmse
  double base_rmse = 0.0;     ///< of the base after the same seconds

  double samples_saved() const { return 1.0 - samples / base_samples; }
  double seconds_saved() const { return 1.0 - seconds / base_seconds; }
  double rmse_ratio() const { return rmse / base_rmse; }
};

/// nullopt where the rmse or the seconds of the point lie beyond those of `base`.
std::optional<ImageErrorMatch> match(const ImageErrorPoint& point, const ImageErrorCurve& base);

}  // namespace bspview
