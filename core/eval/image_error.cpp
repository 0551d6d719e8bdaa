#include "core/eval/image_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/check.h"

namespace bspview {
namespace {

constexpr double dark = 0.01;  // keeps rel_mse finite where the reference is black

double shown(float value) {
  return value > 0.0f ? std::min(static_cast<double>(value), 1.0) : 0.0;  // a NaN becomes 0
}

/// Mean of term(shown, shown of the reference) over pixels and channels; 0 for no pixel.
template <class Term>
double mean_over(const Image& image, const Image& reference, const Term& term) {
  BSPVIEW_CHECK(image.width == reference.width && image.height == reference.height);
  double sum = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      sum += term(shown(image.pixels[i][channel]), shown(reference.pixels[i][channel]));
    }
  }
  return image.pixels.empty() ? 0.0 : sum / (3.0 * static_cast<double>(image.pixels.size()));
}

using Quantity = double (*)(const ImageErrorPoint&);
double samples_of(const ImageErrorPoint& point) {
  return point.samples_per_pixel;
}
double seconds_of(const ImageErrorPoint& point) {
  return point.seconds.median;
}
double rmse_of(const ImageErrorPoint& point) {
  return point.rmse;
}

/// `value` of the curve where `key` is `at`, between the first two neighbours whose keys enclose
/// it; nullopt when none do.
std::optional<double> interpolated(const ImageErrorCurve& curve, Quantity key, double at,
                                   Quantity value) {
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const ImageErrorPoint& a = curve.points[i - 1];
    const ImageErrorPoint& b = curve.points[i];
    if ((key(a) - at) * (key(b) - at) > 0.0 || key(a) == key(b)) continue;
    if (std::min(at, std::min(key(a), key(b))) <= 0.0) continue;
    const double share = std::log(at / key(a)) / std::log(key(b) / key(a));
    return value(a) * std::pow(value(b) / value(a), share);
  }
  return std::nullopt;
}

}  // namespace

double rmse(const Image& image, const Image& reference) {
  return std::sqrt(
      mean_over(image, reference, [](double a, double r) { return (a - r) * (a - r); }));
}

double rel_mse(const Image& image, const Image& reference) {
  return mean_over(image, reference,
                   [](double a, double r) { return (a - r) * (a - r) / (r * r + dark); });
}

ImageBias image_bias(const Image& image, const Image& whole) {
  return {mean_over(image, whole, [](double a, double b) { return a - b; }),
          mean_over(image, whole, [](double a, double b) { return std::abs(a - b); }),
          rmse(image, whole)};
}

std::optional<double> samples_for(const ImageErrorCurve& curve, double rmse) {
  return interpolated(curve, rmse_of, rmse, samples_of);
}

std::optional<double> seconds_for(const ImageErrorCurve& curve, double rmse) {
  return interpolated(curve, rmse_of, rmse, seconds_of);
}

std::optional<double> rmse_after(const ImageErrorCurve& curve, double seconds) {
  return interpolated(curve, seconds_of, seconds, rmse_of);
}

std::optional<ImageErrorMatch> match(const ImageErrorPoint& point, const ImageErrorCurve& base) {
  const auto samples = samples_for(base, point.rmse);
  const auto seconds = seconds_for(base, point.rmse);
  const auto error = rmse_after(base, point.seconds.median);
  if (!samples || !seconds || !error) return std::nullopt;
  return ImageErrorMatch{.name = point.name,
                         .rmse = point.rmse,
                         .samples = point.samples_per_pixel,
                         .base_samples = *samples,
                         .seconds = point.seconds.median,
                         .base_seconds = *seconds,
                         .base_rmse = *error};
}

}  // namespace bspview
