#include "core/bsp/cost.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bspview {
namespace {

constexpr CostModel model{.traversal = 1.0, .intersection = 2.0, .empty_factor = 0.5};

TEST(SplitTests, WeighsBothSidesByTheirArea) {
  const Aabb cell{Vec3(0.0f), Vec3(4.0f, 2.0f, 1.0f)};
  // Half areas: 4 * 2 + 2 * 1 + 1 * 4 = 14; left of x = 1: 2 + 2 + 1 = 5; right: 6 + 2 + 3 = 11.
  const SplitTests tests(model, cell, 0);
  EXPECT_NEAR(tests(1.0, 3, 4), (3 * 5.0 + 4 * 11.0) / 14.0, 1e-12);
}

TEST(SplitTests, ManyObjectsThatAreDividedFurtherAreFewerThanInALeaf) {
  for (std::uint32_t count = 0; count <= 64; ++count) EXPECT_EQ(tests_below(count), count);
  EXPECT_DOUBLE_EQ(tests_below(1u << 16), 65536.0 * std::pow(0x1p-10, 0.3));
  double before = 64.0, step = 1.0;
  for (std::uint32_t count = 65; count < 5000; ++count) {
    const double tests = tests_below(count);
    EXPECT_LE(tests - before, step + 1e-9) << count;  // less and less for one more
    EXPECT_GT(tests, before) << count;
    step = tests - before;
    before = tests;
  }
  EXPECT_GT(tests_below(0xffffffffu), tests_below(0x80000000u));
}

TEST(SplitTests, SparesSomeWherePlanesCutOffEmptySpace) {
  const Aabb cell{Vec3(0.0f), Vec3(2.0f)};
  const SplitTests tests(model, cell, 2);
  EXPECT_NEAR(tests(1.0, 0, 4), 0.5 * 4 * 8.0 / 12.0, 1e-12);
  EXPECT_NEAR(tests(1.0, 4, 0), tests(1.0, 0, 4), 1e-12);
}

TEST(SplitTests, SplitsACellWithoutAreaByLength) {
  const Aabb line{Vec3(0.0f), Vec3(4.0f, 0.0f, 0.0f)};
  const SplitTests tests(model, line, 0);
  EXPECT_NEAR(tests(1.0, 3, 4), 3 * 0.25 + 4 * 0.75, 1e-12);
}

TEST(SplitTests, SurvivesTheLargestBoxes) {
  const float largest = std::numeric_limits<float>::max();
  const Aabb cell{Vec3(-largest), Vec3(largest)};
  EXPECT_NEAR(SplitTests(model, cell, 1)(0.0, 3, 3), 6 * 2.0 / 3.0, 1e-9);
}

TEST(CrossingProbability, IsTheRatioOfAreasOrLengths) {
  const Aabb cube{Vec3(0.0f), Vec3(2.0f)};
  EXPECT_EQ(crossing_probability(split_cell(cube, 0, 1.0f).left, cube), 8.0 / 12.0);
  const Aabb line{Vec3(0.0f), Vec3(0.0f, 4.0f, 0.0f)};
  EXPECT_EQ(crossing_probability(split_cell(line, 1, 1.0f).left, line), 0.25);
  const Aabb point{Vec3(1.0f), Vec3(1.0f)};
  EXPECT_EQ(crossing_probability(point, point), 1.0);
  EXPECT_EQ(crossing_probability(Aabb{}, Aabb{}), 1.0);
}

TEST(CostModel, TakesNonsenseAsZero) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const CostModel costs =
      cost_model({.cost_traversal = -1.0f, .cost_intersection = nan, .empty_bonus = 7.0f}, 2.0f);
  EXPECT_EQ(costs.traversal, 0.0);
  EXPECT_EQ(costs.intersection, 0.0);
  EXPECT_EQ(costs.empty_factor, 0.0);
}

TEST(CostModel, APlanePaysWhereItSavesTheTestsThatANodeCosts) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(model.least_saving(), 0.5);
  EXPECT_EQ((CostModel{.traversal = 1.0, .intersection = 0.0}.least_saving()), infinity);
  EXPECT_EQ((CostModel{.traversal = 0.0, .intersection = 0.0}.least_saving()), 0.0);
}

TEST(CostModel, TestsCostWhatTheParametersSayOrElseWhatTheObjectsDo) {
  EXPECT_EQ(cost_model({}, 2.5f).intersection, 2.5);
  EXPECT_EQ(cost_model({.cost_intersection = 4.0f}, 2.5f).intersection, 4.0);
}

}  // namespace
}  // namespace bspview
