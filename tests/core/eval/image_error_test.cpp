#include "core/eval/image_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bspview {
namespace {

Image two_pixels(Vec3 left, Vec3 right) {
  return {2, 1, {left, right}};
}

TEST(ImageError, IsNoneOfAPictureAgainstItself) {
  const Image image = two_pixels(Vec3(0.1f, 0.7f, 2.0f), Vec3(0.0f));
  EXPECT_EQ(rmse(image, image), 0.0);
  EXPECT_EQ(rel_mse(image, image), 0.0);
  EXPECT_EQ(rmse(Image{}, Image{}), 0.0);
}

TEST(ImageError, FollowsItsFormula) {
  const Image image = two_pixels(Vec3(0.75f, 0.5f, 0.5f), Vec3(0.0f));
  const Image reference = two_pixels(Vec3(0.25f, 0.5f, 0.5f), Vec3(0.0f, 0.0f, 0.5f));
  EXPECT_DOUBLE_EQ(rmse(image, reference), std::sqrt(2 * 0.25 / 6));
  EXPECT_DOUBLE_EQ(rel_mse(image, reference), (0.25 / (0.0625 + 0.01) + 0.25 / (0.25 + 0.01)) / 6);
}

TEST(ImageError, IsOfTheColoursAsTheyAreShown) {
  const Image bright = two_pixels(Vec3(5.0f), Vec3(-3.0f));
  const Image white = two_pixels(Vec3(1.0f), Vec3(0.0f));
  EXPECT_EQ(rmse(bright, white), 0.0);
  const Image nan = two_pixels(Vec3(1.0f), Vec3(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(rmse(nan, white), 0.0);
}

TEST(ImageError, BiasIsAMeanOfDifferences) {
  const Image image = two_pixels(Vec3(0.75f, 0.5f, 0.5f), Vec3(9.0f));
  const Image whole = two_pixels(Vec3(0.25f, 0.5f, 0.75f), Vec3(2.0f));
  const ImageBias bias = image_bias(image, whole);
  EXPECT_DOUBLE_EQ(bias.signed_mean, 0.25 / 6);
  EXPECT_DOUBLE_EQ(bias.absolute_mean, 0.75 / 6);
  EXPECT_DOUBLE_EQ(bias.root_mean_square, std::sqrt(0.3125 / 6));
  EXPECT_EQ(image_bias(whole, whole), ImageBias{});
}

ImageErrorPoint point(double samples, double seconds, double error) {
  ImageErrorPoint point;
  point.name = "p";
  point.samples_per_pixel = samples;
  point.seconds.median = seconds;
  point.rmse = error;
  return point;
}

TEST(ImageError, CurvesAreStraightInLogarithms) {
  const ImageErrorCurve curve{"c", {point(1, 0.5, 0.16), point(4, 2, 0.04), point(16, 8, 0.02)}};
  EXPECT_DOUBLE_EQ(*samples_for(curve, 0.08), 2.0);
  EXPECT_DOUBLE_EQ(*seconds_for(curve, 0.08), 1.0);
  EXPECT_DOUBLE_EQ(*rmse_after(curve, 4.0), std::sqrt(0.04 * 0.02));
  EXPECT_DOUBLE_EQ(*samples_for(curve, 0.16), 1.0);
  EXPECT_DOUBLE_EQ(*samples_for(curve, 0.02), 16.0);
  for (const double outside : {0.17, 0.019, 0.0}) EXPECT_FALSE(samples_for(curve, outside));
  EXPECT_FALSE(rmse_after(curve, 9.0));
  EXPECT_FALSE(samples_for({}, 0.1));
}

TEST(ImageError, AMatchSaysWhatAPointSaves) {
  const ImageErrorCurve base{"b", {point(1, 0.5, 0.16), point(4, 2, 0.04), point(16, 8, 0.02)}};
  for (const auto& beyond : {point(8, 9, 0.02), point(8, 8, 0.01)}) {
    EXPECT_FALSE(match(beyond, base));
  }
  const auto against = match(point(1, 1.0, 0.04), base);
  ASSERT_TRUE(against);
  EXPECT_DOUBLE_EQ(against->samples_saved(), 0.75);
  EXPECT_DOUBLE_EQ(against->seconds_saved(), 0.5);
  EXPECT_DOUBLE_EQ(against->rmse_ratio(), 0.5);
}

}  // namespace
}  // namespace bspview
