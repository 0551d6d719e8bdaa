#include <gtest/gtest.h>

#include "core/eval/image_error.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

struct SmallWorld {
  Scene scene = test::random_scene(30, 4);
  Tree tree = *build_scene_tree(scene, {});
  ImageErrorParams params;
  SmallWorld() {
    params.render.width = params.render.height = 24;
    params.reference_samples = 64;
    params.samples = {4, 1};
    params.thresholds = {0.01f, 0.5f};
    params.adaptive_samples = 16;
    params.cutoffs = {0.01f};
    params.cutoff_samples = {4, 1};
    params.repeats = 2;
  }
  auto measure(const Watch& watch = {}) const {
    return measure_image_error({scene, tree}, scene.camera, params, watch);
  }
};

TEST(MeasureImageError, GivesACurveForEachMethodFromFewToManySamples) {
  const auto curves = SmallWorld().measure();
  ASSERT_TRUE(curves.ok());
  std::vector<std::string> names;
  for (const ImageErrorCurve& curve : *curves) {
    for (const ImageErrorPoint& point : curve.points) {
      names.push_back(curve.name + ": " + point.name);
      EXPECT_EQ(point.seconds.repeats, 2);
      EXPECT_GT(point.seconds.median, 0.0);
      EXPECT_GT(point.rmse, 0.0);
      EXPECT_GT(point.rel_mse, 0.0);
    }
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"uniform: 1 samples", "uniform: 4 samples",
                                      "adaptive: threshold 0.5", "adaptive: threshold 0.01",
                                      "cut-off 0.01: 1 samples", "cut-off 0.01: 4 samples"}));
  const ImageErrorCurve& adaptive = (*curves)[1];
  EXPECT_EQ((*curves)[0].points[1].samples_per_pixel, 4.0);
  EXPECT_EQ(adaptive.points[0].samples_per_pixel, 8.0);
  EXPECT_GT(adaptive.points[1].samples_per_pixel, 8.0);
  EXPECT_LT(adaptive.points[1].rmse, adaptive.points[0].rmse);
}

TEST(MeasureImageError, PointsSayHowTheirPictureIsMade) {
  SmallWorld small;
  small.params.render.spd_rules = true;  // with them there would be nothing to compare
  const auto curves = small.measure();
  const RenderParams& adaptive = (*curves)[1].points[0].params;
  EXPECT_EQ(adaptive.adaptive, 0.5f);
  EXPECT_EQ(adaptive.samples, 16);
  const RenderParams& cut = (*curves)[2].points[1].params;
  EXPECT_EQ(cut.cutoff, 0.01f);
  EXPECT_EQ(cut.samples, 4);
  EXPECT_FALSE(cut.spd_rules);
}

TEST(MeasureImageError, ProgressAddsUpToOne) {
  SmallWorld small;
  small.params.render.threads = 1;
  for (const int repeats : {0, 3}) {
    small.params.repeats = repeats;
    double done = 0.0;
    Watch watch;
    watch.progress = [&](double more) { done += more; };
    ASSERT_TRUE(small.measure(watch).ok());
    EXPECT_NEAR(done, 1.0, 1e-9);
  }
}

TEST(MeasureImageError, BiasIsAgainstThePictureWithEverySampleAndRay) {
  SmallWorld small;
  small.params.thresholds = {0.5f, 1e-9f};
  small.params.cutoffs = {0.2f};
  const auto curves = small.measure();
  for (const ImageErrorPoint& point : (*curves)[0].points) EXPECT_EQ(point.bias, ImageBias{});
  const auto& adaptive = (*curves)[1].points;
  EXPECT_GT(adaptive[0].bias.absolute_mean, adaptive[1].bias.absolute_mean);
  for (const ImageErrorPoint& point : (*curves)[2].points) {
    EXPECT_LT(point.bias.signed_mean, 0.0);  // light is lost
  }
}

TEST(MeasureImageError, AStopEndsItWithoutAResult) {
  std::stop_source stop;
  Watch watch(stop.get_token());
  watch.progress = [&](double) { stop.request_stop(); };
  const auto curves = SmallWorld().measure(watch);
  ASSERT_FALSE(curves.ok());
  EXPECT_EQ(curves.error().message, "stopped");
}

TEST(MeasureImageError, AdaptiveSamplingSavesThreeTenthsOfTheSamples) {
  ImageErrorParams params;
  params.render.width = params.render.height = 80;
  params.reference_samples = 128;
  params.samples = {16, 32};
  params.thresholds = {0.01f};
  params.adaptive_samples = 32;
  params.cutoffs = {};
  params.repeats = 0;
  for (const char* name : {"balls", "teapot"}) {
    const Scene scene = *make_spd(name);
    const Tree tree = *build_scene_tree(scene, {});
    const auto curves = measure_image_error({scene, tree}, scene.camera, params);
    ASSERT_TRUE(curves.ok());
    const ImageErrorPoint& adaptive = (*curves)[1].points[0];
    const auto uniform = samples_for((*curves)[0], adaptive.rmse);
    ASSERT_TRUE(uniform) << name;
    EXPECT_LT(adaptive.samples_per_pixel, 0.7 * *uniform) << name;
  }
}

}  // namespace
}  // namespace bspview
