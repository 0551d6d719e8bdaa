#include "app/viewer/overlays/legend.h"

#include <gtest/gtest.h>

#include "app/viewer/overlays/rgba.h"

namespace bspview {
namespace {

std::vector<std::string> labels_of(const Legend& legend) {
  std::vector<std::string> labels;
  for (const LegendTick& tick : legend.ticks) labels.push_back(tick.label);
  return labels;
}

ColorScale linear(float lo, float hi) {
  return {.lo = lo, .hi = hi};
}
ColorScale logarithmic(float hi) {
  return {.hi = hi, .spacing = ColorScale::Spacing::logarithmic};
}

using Labels = std::vector<std::string>;

TEST(Legend, LinearTicksAreRoundValuesBetweenTheEnds) {
  EXPECT_EQ(labels_of(make_legend(linear(0.0f, 20.0f), "")), (Labels{"0", "5", "10", "15", "20"}));
  EXPECT_EQ(labels_of(make_legend(linear(0.0f, 23.0f), "")),
            (Labels{"0", "5", "10", "15", "20", "23"}));
  EXPECT_EQ(labels_of(make_legend(linear(0.0f, 3.0f), "")), (Labels{"0", "1", "2", "3"}));
  EXPECT_EQ(labels_of(make_legend(linear(0.0f, 0.3f), "")), (Labels{"0", "0.1", "0.2", "0.3"}));
}

TEST(Legend, LogarithmicTicksThinOutEvenly) {
  EXPECT_EQ(labels_of(make_legend(logarithmic(1.0f), "")), (Labels{"0", "1"}));
  EXPECT_EQ(labels_of(make_legend(logarithmic(7.0f), "")), (Labels{"0", "1", "2", "5", "7"}));
  EXPECT_EQ(labels_of(make_legend(logarithmic(1000.0f), "")),
            (Labels{"0", "1", "10", "100", "1000"}));
}

TEST(Legend, TicksNeverExceedTheirNumberNorCrowd) {
  for (float hi = 1.0f; hi < 1e6f; hi *= 1.37f) {
    for (const ColorScale& scale : {linear(0.0f, std::round(hi)), logarithmic(std::round(hi))}) {
      const Legend legend = make_legend(scale, "", 6);
      EXPECT_LE(legend.ticks.size(), 7u) << hi;
      EXPECT_EQ(legend.ticks.front().position, 0.0f);
      EXPECT_EQ(legend.ticks.back().position, 1.0f);
      for (std::size_t i = 1; i < legend.ticks.size(); ++i) {
        EXPECT_GE(legend.ticks[i].position - legend.ticks[i - 1].position, 0.079f) << hi;
      }
    }
  }
}

TEST(Legend, ARangeWithoutExtentHasOneTick) {
  EXPECT_EQ(labels_of(make_legend(linear(0.0f, 0.0f), "")), Labels{"0"});
}

TEST(Legend, ColoursAreThoseOfTheScale) {
  const ColorScale scale = linear(0.0f, 10.0f);
  const Legend legend = make_legend(scale, "Depth of leaf");
  EXPECT_EQ(legend.title, "Depth of leaf");
  EXPECT_EQ(legend.colors.front(), pack_color(color_at(scale, 0.0f)));
  EXPECT_EQ(legend.colors.back(), pack_color(color_at(scale, 1.0f)));
}

TEST(Legend, TitlesNameWhatTheColourMeans) {
  EXPECT_EQ(legend_title(LeafColor::objects), "Objects per leaf");
  EXPECT_EQ(legend_title(LeafColor::depth), "Depth of leaf");
  EXPECT_EQ(legend_title(LeafColor::plain), "");
}

TEST(ColorScale, PositionsAreClampedToTheScale) {
  EXPECT_EQ(position_on(linear(2.0f, 4.0f), 3.0f), 0.5f);
  EXPECT_EQ(position_on(linear(2.0f, 4.0f), 1.0f), 0.0f);
  EXPECT_EQ(position_on(linear(2.0f, 4.0f), 9.0f), 1.0f);
  EXPECT_EQ(position_on(linear(4.0f, 4.0f), 4.0f), 0.0f);
  EXPECT_FLOAT_EQ(position_on(logarithmic(15.0f), 3.0f), 0.5f);
}

}  // namespace
}  // namespace bspview
