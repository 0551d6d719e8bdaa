#include "core/render/adaptive.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/parallel.h"
#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

constexpr int width = 40, height = 20;         // six tiles, not all whole
constexpr std::size_t noisy = 9 * width + 15;  // last of its tile: two of its neighbours lie beyond

/// Gives every pixel that lives `count` samples: `noisy` turns from `low` to `high` and back.
void add_samples(PixelSamples& samples, int count, Vec3 low, Vec3 high) {
  for (int i = 0; i < count; ++i) {
    for (std::size_t pixel = 0; pixel < width * height; ++pixel) {
      if (samples.lives(pixel)) samples.add(pixel, pixel == noisy && i % 2 == 1 ? high : low);
    }
  }
}

std::vector<std::size_t> living(const PixelSamples& samples) {
  std::vector<std::size_t> pixels;
  for (std::size_t pixel = 0; pixel < width * height; ++pixel) {
    if (samples.lives(pixel)) pixels.push_back(pixel);
  }
  return pixels;
}

TEST(Adaptive, PixelsDieWhenTheyAndTheirNeighboursAreSure) {
  PixelSamples samples(width, height, 0.01f);
  add_samples(samples, 8, Vec3(0.25f), Vec3(0.75f));
  EXPECT_EQ(living(samples).size(), std::size_t{width} * height);
  samples.judge({});
  EXPECT_EQ(living(samples),
            (std::vector<std::size_t>{noisy - width - 1, noisy - width, noisy - width + 1,
                                      noisy - 1, noisy, noisy + 1, noisy + width - 1, noisy + width,
                                      noisy + width + 1}));
  EXPECT_TRUE(samples.any_lives());
  EXPECT_TRUE(samples.any_lives_in(0));
  EXPECT_TRUE(samples.any_lives_in(1));
  EXPECT_FALSE(samples.any_lives_in(2));
}

TEST(Adaptive, ADeadPixelStaysDead) {
  PixelSamples samples(width, height, 0.01f);
  add_samples(samples, 8, Vec3(0.5f), Vec3(0.5f));
  samples.judge({});
  EXPECT_FALSE(samples.any_lives());
  samples.judge({});
  EXPECT_TRUE(living(samples).empty());
}

TEST(Adaptive, AnErrorBeyondWhiteOrBelowBlackIsNone) {
  for (const auto& [low, high] :
       {std::pair(2.0f, 3.0f), std::pair(-2.0f, -1.0f), std::pair(0.0f, 2.2f)}) {
    PixelSamples samples(width, height, 0.01f);
    add_samples(samples, 8, Vec3(low), Vec3(high));
    samples.judge({});
    EXPECT_EQ(samples.any_lives(), low == 0.0f) << low;  // 1.1 +- 0.25 reaches below white
  }
}

TEST(Adaptive, TheWorstChannelDecides) {
  PixelSamples samples(width, height, 0.01f);
  add_samples(samples, 8, Vec3(0.5f), Vec3(0.5f, 0.5f, 0.6f));
  samples.judge({});
  EXPECT_EQ(living(samples).size(), 9u);
}

TEST(Adaptive, AColourThatIsNoNumberKeepsNoPixelAlive) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  for (const float bad : {inf, -inf, std::numeric_limits<float>::quiet_NaN()}) {
    PixelSamples samples(width, height, 0.01f);
    add_samples(samples, 8, Vec3(0.5f), Vec3(bad));
    samples.judge({});
    EXPECT_FALSE(samples.any_lives()) << bad;
  }
}

TEST(Adaptive, AtThresholdZeroNothingIsJudged) {
  PixelSamples samples(width, height, 0.0f);
  add_samples(samples, 8, Vec3(0.5f), Vec3(0.5f));
  samples.judge({});
  EXPECT_EQ(living(samples).size(), std::size_t{width} * height);
  EXPECT_EQ(samples.mean(3), Vec3(0.5f));
}

}  // namespace
}  // namespace bspview
