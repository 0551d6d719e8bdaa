#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/run_time.h"
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
  for (const int samples : cutoff > 0.0f ? params.cutoff_samples : params.samples) {
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

bool is_whole(const RenderParams& picture) {
  return picture.adaptive == 0.0f && picture.cutoff == 0.0f;
}

/// Measures the points of planned curves; once a stop is requested it does nothing.
class Experiment {
 public:
  Experiment(const World& world, const Camera& camera, const ImageErrorParams& params,
             const Watch& watch)
      : world_(world), camera_(camera), params_(params), watch_(watch) {}

  /// Work is told in samples: those of every picture of every run.
  void plan(const std::vector<ImageErrorCurve>& curves) {
    std::set<int> wholes{params_.reference_samples};
    for (const ImageErrorCurve& curve : curves) {
      for (const ImageErrorPoint& point : curve.points) {
        const int runs = params_.repeats + (is_whole(point.params) ? 0 : 1);
        work_ += static_cast<double>(point.params.samples) * runs;
        wholes.insert(point.params.samples);
      }
    }
    for (const int samples : wholes) work_ += samples;
  }

  void compare(ImageErrorPoint& point) {
    const Image* reference = whole(params_.reference_samples);
    const Image* same_samples = whole(point.params.samples);
    if (reference == nullptr || same_samples == nullptr) return;
    const auto judge = [&](const Image& image) {
      point.rmse = rmse(image, *reference);
      point.rel_mse = rel_mse(image, *reference);
      point.bias = image_bias(image, *same_samples);
    };
    point.samples_per_pixel = point.params.samples;
    if (is_whole(point.params)) return judge(*same_samples);
    const auto picture = render_counted(world_, camera_, point.params, part(point.params));
    if (!picture) return;
    judge(picture->image);
    point.samples_per_pixel = static_cast<double>(picture->counts.primary) /
                              static_cast<double>(picture->image.pixels.size());
  }

  /// Repeats are interleaved, so that what slows the machine down for a while slows all.
  void time(std::vector<ImageErrorCurve>& curves) {
    std::vector<Clock> clocks;
    for (ImageErrorCurve& curve : curves) {
      for (ImageErrorPoint& point : curve.points) clocks.push_back({&point, {}});
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
  };

  void time_once(Clock& clock) {
    RenderParams picture = clock.point->params;
    picture.threads = params_.timing_threads;
    const Watch watch = part(picture);
    bool done = false;
    const double seconds = time_run(
        params_.timing_threads, [&] { done = render_image(world_, camera_, picture, watch).ok(); });
    if (done) clock.seconds.push_back(seconds);
  }

  /// The picture with as many samples in every pixel and every ray shot; null: stopped.
  const Image* whole(int samples) {
    if (const auto made = wholes_.find(samples); made != wholes_.end()) return &made->second;
    const RenderParams picture = plain_picture(params_, samples);
    auto image = render_image(world_, camera_, picture, part(picture));
    return image ? &wholes_.emplace(samples, std::move(*image)).first->second : nullptr;
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
  std::map<int, Image> wholes_;  // by samples a pixel
  double work_ = 0.0;
};

}  // namespace

Result<std::vector<ImageErrorCurve>> measure_image_error(const World& world, const Camera& camera,
                                                         const ImageErrorParams& params,
                                                         const Watch& watch) {
  std::vector<ImageErrorCurve> curves = planned_curves(params);
  Experiment experiment(world, camera, params, watch);
  experiment.plan(curves);
  for (ImageErrorCurve& curve : curves) {
    for (ImageErrorPoint& point : curve.points) experiment.compare(point);
  }
  experiment.time(curves);
  if (watch.stopped()) return Error{"stopped"};
  return curves;
}

}  // namespace bspview
