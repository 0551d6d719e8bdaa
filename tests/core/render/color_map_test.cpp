#include "core/render/color_map.h"

#include <limits>

#include <gtest/gtest.h>

namespace bspview {
namespace {

constexpr ColorMap maps[] = {ColorMap::viridis, ColorMap::cividis, ColorMap::magma, ColorMap::grey};

float lightness(Vec3 color) {
  return 0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b;
}

TEST(ColorMap, LightnessNeverFalls) {
  for (const ColorMap map : maps) {
    for (int i = 0; i < 1000; ++i) {
      const float darker = lightness(sample(map, static_cast<float>(i) / 1000.0f));
      const float lighter = lightness(sample(map, static_cast<float>(i + 1) / 1000.0f));
      EXPECT_LE(darker, lighter + 1e-3f) << static_cast<int>(map) << " at " << i;
    }
  }
}

TEST(ColorMap, EndsAreThePublishedColours) {
  EXPECT_EQ(sample(ColorMap::viridis, 0.0f), Vec3(0x44, 0x01, 0x54) / 255.0f);
  EXPECT_EQ(sample(ColorMap::viridis, 1.0f), Vec3(0xfd, 0xe7, 0x25) / 255.0f);
  EXPECT_EQ(sample(ColorMap::cividis, 1.0f), Vec3(0xfe, 0xe8, 0x38) / 255.0f);
  EXPECT_EQ(sample(ColorMap::magma, 0.0f), Vec3(0x00, 0x00, 0x04) / 255.0f);
  EXPECT_EQ(sample(ColorMap::grey, 0.25f), Vec3(0.25f));
}

TEST(ColorMap, ValuesOutsideTheRangeTakeTheNearestEnd) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const ColorMap map : maps) {
    EXPECT_EQ(sample(map, -infinity), sample(map, 0.0f));
    EXPECT_EQ(sample(map, std::numeric_limits<float>::quiet_NaN()), sample(map, 0.0f));
    EXPECT_EQ(sample(map, 2.0f), sample(map, 1.0f));
    EXPECT_EQ(sample(map, infinity), sample(map, 1.0f));
  }
}

TEST(ColorMap, EveryMapHasAName) {
  EXPECT_EQ(color_map_names().size(), std::size(maps));
}

}  // namespace
}  // namespace bspview
