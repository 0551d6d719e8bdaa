#include "app/viewer/overlays/rgba.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/viewer/overlays/layer.h"

namespace bspview {
namespace {

TEST(Rgba, RedIsInTheLowestByteAndAlphaInTheHighest) {
  EXPECT_EQ(pack_color({1.0f, 0.0f, 0.0f}), 0xff0000ffu);
  EXPECT_EQ(pack_color({0.0f, 1.0f, 0.0f}, 0.0f), 0x0000ff00u);
  EXPECT_EQ(pack_color({0.0f, 0.0f, 1.0f}, 0.5f), 0x80ff0000u);
  EXPECT_EQ(pack_color({-1.0f, 2.0f, 0.0f}), 0xff00ff00u);
}

TEST(Rgba, ScalingRoundsEveryComponentToTheNearest) {
  for (std::uint32_t component = 0; component < 256; ++component) {
    for (std::uint32_t factor = 0; factor < 256; ++factor) {
      const auto expected =
          static_cast<std::uint32_t>(std::lround(static_cast<double>(component * factor) / 255.0));
      ASSERT_EQ(scale_color(component * 0x01010101u, factor), expected * 0x01010101u);
    }
  }
}

TEST(Rgba, PremultipliedColoursKeepTheirAlpha) {
  EXPECT_EQ(premultiply(0x80ffffffu), 0x80808080u);
  EXPECT_EQ(premultiply(0x00ffffffu), 0u);
  EXPECT_EQ(premultiply(0xff123456u), 0xff123456u);
}

TEST(Layer, LaysOneOverTheOther) {
  Layer below(3, 1), above(3, 1);
  below.pixels = {0xff0000ffu, 0xff0000ffu, 0x80000080u};
  above.pixels = {0x00000000u, 0xff00ff00u, 0x80008000u};
  lay_over(below, above);
  EXPECT_EQ(below.pixels, (std::vector<std::uint32_t>{0xff0000ffu, 0xff00ff00u, 0xc0008040u}));
}

}  // namespace
}  // namespace bspview
