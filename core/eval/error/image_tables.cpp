#include "core/eval/error/image_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/counted.h"

namespace bspview {
namespace {

using Cells = std::vector<std::string>;

/// Seconds, their spread, RMSE and relMSE.
void add_measures(Cells& cells, const ImageErrorPoint& point) {
  cells.push_back(fmt::format("{:.4f}", point.seconds.median));
  cells.push_back(fmt::format("{:.4f}", point.seconds.spread));
  cells.push_back(fmt::format("{:.5f}", point.rmse));
  cells.push_back(fmt::format("{:.2e}", point.rel_mse));
}

/// With so many digits after the point; 0 has no sign.
double rounded(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(value * scale) / scale + 0.0;
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", rounded(100.0 * share, 0));
}

/// `digits` after the point.
void add_bias(Cells& cells, const ImageBias& bias, double unit, int digits) {
  cells.push_back(fmt::format("{:+.{}f}", rounded(bias.signed_mean / unit, digits), digits));
  cells.push_back(fmt::format("{:.{}f}", bias.absolute_mean / unit, digits));
  cells.push_back(fmt::format("{:.{}f}", bias.root_mean_square / unit, digits));
}

ImageTable uniform_table(const SceneImageError& image) {
  ImageTable table{
      "Uniform sampling", "", {"samples a pixel", "seconds", "+-", "RMSE", "relMSE"}, {}};
  for (const ImageErrorPoint& point : image.curves.front().points) {
    Cells cells{fmt::format("{}", point.params.samples)};
    add_measures(cells, point);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Cells adaptive_row(const ImageErrorPoint& point, const ImageErrorCurve& uniform) {
  Cells cells{fmt::format("{}", point.params.adaptive),
              fmt::format("{:.1f}", point.samples_per_pixel)};
  add_measures(cells, point);
  if (const auto against = match(point, uniform)) {
    cells.push_back(fmt::format("{:.1f}", against->base_samples));
    cells.push_back(percent(against->samples_saved()));
    cells.push_back(percent(against->seconds_saved()));
    cells.push_back(fmt::format("x {:.2f}", against->rmse_ratio()));
  } else {
    cells.insert(cells.end(), 4, "-");
  }
  add_bias(cells, point.bias, point.params.adaptive, 3);
  return cells;
}

ImageTable adaptive_table(const SceneImageError& image) {
  const ImageBias& bound = adaptive_bias_bound;
  ImageTable table{
      "Adaptive sampling",
      fmt::format("At most {0} samples a pixel. Samples and time that it saves against uniform "
                  "sampling with the same RMSE; its RMSE over that of uniform sampling after the "
                  "same time. Bias: mean difference from uniform sampling with {0} samples, in "
                  "thresholds; the bounds are {1}, {2} (of absolute differences) and {3} (of their "
                  "root mean square).",
                  image.params.adaptive_samples, bound.signed_mean, bound.absolute_mean,
                  bound.root_mean_square),
      {"threshold", "samples", "seconds", "+-", "RMSE", "relMSE", "uniform needs", "samples saved",
       "time saved", "RMSE, equal time", "bias", "absolute", "RMS"},
      {}};
  for (const ImageErrorCurve& curve : image.curves) {
    for (const ImageErrorPoint& point : curve.points) {
      if (point.params.adaptive == 0.0f) continue;
      table.rows.push_back(adaptive_row(point, image.curves.front()));
    }
  }
  return table;
}

Cells cutoff_row(const ImageErrorPoint& point, const ImageErrorCurve& uniform) {
  Cells cells{fmt::format("{}", point.params.cutoff), fmt::format("{}", point.params.samples)};
  add_measures(cells, point);
  const auto against = match(point, uniform);
  cells.push_back(against ? fmt::format("x {:.2f}", against->seconds / against->base_seconds)
                          : "-");
  cells.push_back(against ? fmt::format("x {:.2f}", against->rmse_ratio()) : "-");
  add_bias(cells, point.bias, 1.0, 5);
  return cells;
}

ImageTable cutoff_table(const SceneImageError& image) {
  ImageTable table{
      "Cut-offs",
      "Time over that of uniform sampling with the same RMSE; RMSE over that of uniform sampling "
      "after the same time. Bias: mean difference from the same samples with every ray shot; of "
      "absolute differences, the cut-off is the bound.",
      {"cut-off", "samples", "seconds", "+-", "RMSE", "relMSE", "time, equal RMSE",
       "RMSE, equal time", "bias", "absolute", "RMS"},
      {}};
  for (const ImageErrorCurve& curve : image.curves) {
    for (const ImageErrorPoint& point : curve.points) {
      if (point.params.cutoff == 0.0f) continue;
      table.rows.push_back(cutoff_row(point, image.curves.front()));
    }
  }
  return table;
}

}  // namespace

std::vector<ImageTable> image_tables(const SceneImageError& image) {
  if (image.curves.empty()) return {};
  return {uniform_table(image), adaptive_table(image), cutoff_table(image)};
}

std::string how_measured(const ImageErrorParams& params) {
  return fmt::format(
      "{} x {} pixels, against {} samples a pixel; median of {} +- half the "
      "distance of the quartiles, {}",
      params.render.width, params.render.height, params.reference_samples,
      counted(params.repeats, "interleaved repeat"), clock_text(params.timing_threads));
}

}  // namespace bspview
