#include <fmt/format.h>

#include <algorithm>

#include "core/base/timer.h"
#include "core/eval/image_error.h"

namespace bspview {
namespace {

/// The picture that every way to make it starts from.
RenderParams plain_picture(const ImageErrorParams& params, int samples) {
  RenderParams picture = params.render;
  picture.samples = samples;
  picture.spd_rules = false;
  picture.cutoff = picture.adaptive = 0.0f;
  return picture;
}

std::vector<RenderParams> uniform_pictures(const ImageErrorParams& params, float cutoff) {
  std::vector<RenderParams> pictures;
  for (const int samples : params.samples) {
    pictures.push_back(plain_picture(params, samples));
    pictures.back().cutoff = cutoff;
  }
  std::ranges::sort(pictures, {}, &RenderParams::samples);
  return pictures;
}

std::vector<RenderParams> adaptive_pictures(const ImageErrorParams& params) {
  std::vector<RenderParams> pictures;
  for (const float threshold : params.thresholds) {
    pictures.push_back(plain_picture(params, params.adaptive_samples));
    pictures.back().adaptive = threshold;
  }
  std::ranges::sort(pictures, std::ranges::greater(), &RenderParams::adaptive);
  return pictures;
}

ImageErrorCurve curve_of(std::string name, const std::vector<RenderParams>& pictures) {
  ImageErrorCurve curve{std::move(name), {}};
  for (const RenderParams& picture : pictures) {
    ImageErrorPoint point;
    point.name = picture.adaptive > 0.0f ? fmt::format("threshold {}", picture.adaptive)
                                         : fmt::format("{} samples", picture.samples);
    point.params = picture;
    curve.points.push_back(std::move(point));
  }
  return curve;
}

std::vector<ImageErrorCurve> planned_curves(const ImageErrorParams& params) {
  std::vector<ImageErrorCurve> curves{curve_of("uniform", uniform_pictures(params, 0.0f)),
                                      curve_of("adaptive", adaptive_pictures(params))};
  for (const float cutoff : params.cutoffs) {
    curves.push_back(curve_of(fmt::format("cut-off {}", cutoff), uniform_pictures(params, cutoff)));
  }
  return curves;
}

/// Measures the points of planned curves; once a stop is requested it does nothing.
class Experiment {
 public:
  Experiment(const World& world, const Camera& camera, const ImageErrorParams& params,
             const Watch& watch)
      : world_(world), camera_(camera), params_(params), watch_(watch) {}

  /// Work is told in samples: those of the converged picture and of every picture of every run.
  void plan(const std::vector<ImageErrorCurve>& curves) {
    work_ = params_.reference_samples;
    for (const ImageErrorCurve& curve : curves) {
      for (const ImageErrorPoint& point : curve.points) {
        work_ += point.params.samples * (1.0 + params_.repeats);
      }
    }
  }

  void make_reference() {
    const RenderParams converged = plain_picture(params_, params_.reference_samples);
    if (auto image = render_image(world_, camera_, converged, part(converged)); image) {
      reference_ = std::move(*image);
    }
  }

  void compare(ImageErrorPoint& point) {
    const auto picture = render_counted(world_, camera_, point.params, part(point.params));
    if (!picture) return;
    point.samples_per_pixel = static_cast<double>(picture->counts.primary) /
                              static_cast<double>(picture->image.pixels.size());
    point.rmse = rmse(picture->image, reference_);
    point.rel_mse = rel_mse(picture->image, reference_);
  }

  /// Repeats are interleaved, so that what slows the machine down for a while slows all.
  void time(std::vector<ImageErrorCurve>& curves) {
    std::vector<Clock> clocks;
    for (ImageErrorCurve& curve : curves) {
      for (ImageErrorPoint& point : curve.points) clocks.push_back({&point, {}, 0.0});
    }
    for (int repeat = 0; repeat < params_.repeats; ++repeat) {
      for (Clock& clock : clocks) time_once(clock);
    }
    for (Clock& clock : clocks) clock.point->seconds = summarise(std::move(clock.seconds));
  }

 private:
  struct Clock {
    ImageErrorPoint* point;
    std::vector<double> seconds;  // of each repeat
    double spent = 0.0;           // their sum
  };

  void time_once(Clock& clock) {
    const RenderParams& picture = clock.point->params;
    const Watch watch = part(picture);
    if (clock.spent > params_.patience) return watch.advance(1.0);
    const Timer timer;
    if (!render_image(world_, camera_, picture, watch)) return;
    clock.seconds.push_back(timer.seconds());
    clock.spent += clock.seconds.back();
  }

  /// For one picture, whose progress is a share of that of all.
  Watch part(const RenderParams& picture) const {
    Watch part(watch_.stop);
    const double share = picture.samples / work_;
    part.progress = [this, share](double more) { watch_.advance(share * more); };
    return part;
  }

  const World& world_;
  const Camera& camera_;
  const ImageErrorParams& params_;
  const Watch& watch_;
  Image reference_;
  double work_ = 0.0;
};

}  // namespace

Result<std::vector<ImageErrorCurve>> measure_image_error(const World& world, const Camera& camera,
                                                         const ImageErrorParams& params,
                                                         const Watch& watch) {
  std::vector<ImageErrorCurve> curves = planned_curves(params);
  Experiment experiment(world, camera, params, watch);
  experiment.plan(curves);
  experiment.make_reference();
  for (ImageErrorCurve& curve : curves) {
    for (ImageErrorPoint& point : curve.points) experiment.compare(point);
  }
  experiment.time(curves);
  if (watch.stopped()) return Error{"stopped"};
  return curves;
}

}  // namespace bspview
