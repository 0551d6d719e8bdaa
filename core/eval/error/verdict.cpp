#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/eval/error/report.h"

namespace bspview {
namespace {

std::string rays_verdict(const ErrorReport& report) {
  const ErrorPool all = pool_of_all(report);
  const auto find = [&](std::size_t config) {
    return *std::ranges::find(all.configs, config, &PooledConfig::config);
  };
  const auto wrong = [](const ErrorCounts& counts) {
    return counts.ordinary().wrong() + counts.aimed().wrong();
  };
  const auto& own = find(report.pictures_config);
  const auto& fastest = find(price_of(report.pictures_config, report).fastest);
  const std::uint64_t rays = own.counts.ordinary().rays + own.counts.aimed().rays;
  const double slower = own.ns / fastest.ns - 1.0;
  return fmt::format(
      "default: {} wrong of {} rays, {} acne, {} light leaks, {:.1f} % {} than the fastest in "
      "float ({}), which gets {} rays wrong, {} acne and {} light leaks: {}.",
      wrong(own.counts), rays, own.counts.offset.acne, own.counts.offset.leaks,
      std::abs(100.0 * slower), slower >= 0.0 ? "slower" : "faster",
      report.configs[fastest.config].name, wrong(fastest.counts), fastest.counts.offset.acne,
      fastest.counts.offset.leaks,
      wrong(own.counts) < wrong(fastest.counts) ? "keep the default"
                                                : "float is as good on these rays");
}

/// A point set against uniform sampling.
struct Judged {
  const ImageErrorPoint* point;
  ImageErrorMatch against;
};

template <class Wanted>
std::vector<Judged> judged_points(const SceneImageError& image, const Wanted& wanted) {
  std::vector<Judged> judged;
  for (const ImageErrorCurve& curve : image.curves) {
    for (const ImageErrorPoint& point : curve.points) {
      if (!wanted(point.params)) continue;
      if (const auto against = match(point, image.curves.front()))
        judged.push_back({&point, *against});
    }
  }
  return judged;
}

/// Gains of less are not worth a word: the clock's repeats differ by as much.
constexpr double least_gain = 0.02;

std::string adaptive_verdict(const SceneImageError& image) {
  const auto judged =
      judged_points(image, [](const RenderParams& params) { return params.adaptive > 0.0f; });
  if (judged.empty()) {
    return image.scene + ": no threshold leads to an error that was measured of uniform sampling.";
  }
  const auto& most = *std::ranges::max_element(
      judged, {}, [](const Judged& one) { return one.against.samples_saved(); });
  const auto& soonest = *std::ranges::max_element(
      judged, {}, [](const Judged& one) { return one.against.seconds_saved(); });
  double bias = 0.0;
  for (const auto& [point, against] : judged) {
    bias = std::max(bias, std::abs(point->bias.signed_mean / point->params.adaptive));
  }
  std::string text = fmt::format(
      "{}: adaptive sampling with threshold {} saves {:.0f} % of the samples at equal RMSE ({:.1f} "
      "a pixel instead of {:.1f}, RMSE {:.4f}); bias at most {:.3f} thresholds (bound {}).",
      image.scene, most.point->params.adaptive, 100.0 * most.against.samples_saved(),
      most.against.samples, most.against.base_samples, most.against.rmse, bias,
      adaptive_bias_bound.signed_mean);
  if (soonest.against.seconds_saved() < least_gain) {
    return text +
           " It saves no time, since the pixels that go on are the dear ones: for time, "
           "sample uniformly.";
  }
  return text + fmt::format(" Most time is saved by --adaptive {}: {:.0f} %, at RMSE {:.4f}.",
                            soonest.point->params.adaptive, 100.0 * soonest.against.seconds_saved(),
                            soonest.against.rmse);
}

std::string cutoff_verdict(const SceneImageError& image) {
  const auto judged =
      judged_points(image, [](const RenderParams& params) { return params.cutoff > 0.0f; });
  if (judged.empty()) {
    return image.scene + ": no cut-off leads to an error that was measured without one.";
  }
  const auto& best = *std::ranges::min_element(
      judged, {}, [](const Judged& one) { return one.against.rmse_ratio(); });
  const std::string measured = fmt::format(
      "{}: the best cut-off, {}, has {:.2f} times the RMSE after the time of {} samples",
      image.scene, best.point->params.cutoff, best.against.rmse_ratio(),
      best.point->params.samples);
  return measured + (best.against.rmse_ratio() < 1.0 - least_gain
                         ? fmt::format(": use --cutoff {} for so few.", best.point->params.cutoff)
                         : ": leave it at 0.");
}

}  // namespace

std::string embree_sentence(const ErrorReport& report) {
  if (has_foreign(report)) return "";
  return "Embree is not compared with: libembree-dev was not there when bspeval was built.";
}

std::string clock_text(int timing_threads) {
  return timing_threads == 1 ? "processor time of one thread"
                             : fmt::format("wall-clock time of {} threads", timing_threads);
}

std::vector<std::string> verdict(const ErrorStudy& study) {
  std::vector<std::string> sentences;
  if (!study.rays.scenes.empty()) sentences.push_back(rays_verdict(study.rays));
  for (const SceneImageError& image : study.images) {
    if (image.curves.empty()) continue;
    sentences.push_back(adaptive_verdict(image));
    sentences.push_back(cutoff_verdict(image));
  }
  return sentences;
}

}  // namespace bspview
