#include "core/eval/histogram.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(Histogram, DepthsGoFromTheShallowestLeafToTheDeepest) {
  TreeStats stats;
  stats.leaves_at_depth = {0, 0, 3, 0, 5, 0};
  EXPECT_EQ(depth_bars(stats), (std::vector<Bar>{{2, 2, 3}, {3, 3, 0}, {4, 4, 5}}));
}

TEST(Histogram, LargeLeavesShareBarsUpToPowersOfTwo) {
  TreeStats stats;
  stats.leaves_with_count.assign(34, 0);
  stats.leaves_with_count[0] = 4;
  for (const std::size_t size : {8, 9, 16, 17, 32, 33}) stats.leaves_with_count[size] = 1;
  const std::vector<Bar> bars = leaf_size_bars(stats);
  ASSERT_EQ(bars.size(), 12u);
  EXPECT_EQ(bars[0], (Bar{0, 0, 4}));
  EXPECT_EQ(bars[8], (Bar{8, 8, 1}));
  EXPECT_EQ(bars[9], (Bar{9, 16, 2}));
  EXPECT_EQ(bars[10], (Bar{17, 32, 2}));
  EXPECT_EQ(bars[11], (Bar{33, 64, 1}));
}

TEST(Histogram, NoLeavesMakeNoBars) {
  EXPECT_TRUE(depth_bars({}).empty());
  EXPECT_TRUE(leaf_size_bars({}).empty());
}

TEST(Histogram, BarsAreInProportionAndTheSmallestIsSeen) {
  EXPECT_EQ(format_bars({{0, 0, 1000}, {1, 1, 500}, {2, 2, 1}, {3, 3, 0}, {9, 16, 0}}, "size"),
            "size      leaves\n"
            "   0        1000  ################################################\n"
            "   1         500  ########################\n"
            "   2           1  #\n"
            "   3           0\n"
            "9-16           0\n");
}

}  // namespace
}  // namespace bspview
