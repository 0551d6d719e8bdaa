#include "core/eval/error/pareto.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

using Indices = std::vector<std::size_t>;

TEST(Pareto, WhatIsSlowerAndNoBetterIsOffTheFront) {
  const std::vector<TradeOff> points{{1, 0, 100}, {2, 0, 10}, {3, 0, 10}, {3, 0, 50}, {4, 0, 1}};
  EXPECT_EQ(pareto_front(points), (Indices{0, 1, 4}));
}

TEST(Pareto, DifferencesWithinTwiceTheDeviationDoNotCount) {
  const std::vector<TradeOff> points{{1.0, 0.1, 10}, {1.15, 0.05, 20}, {1.25, 0.05, 20}};
  EXPECT_EQ(pareto_front(points), (Indices{0, 1}));
  EXPECT_EQ(pareto_line(points), (Indices{0}));
}

TEST(Pareto, FrontsRunFromTheFastestToTheSlowest) {
  const std::vector<TradeOff> points{{4, 0, 1}, {1, 0, 100}, {2, 0, 10}};
  EXPECT_EQ(pareto_front(points), (Indices{1, 2, 0}));
}

TEST(Pareto, TheKneeLiesFarthestBelowTheLineBetweenTheEnds) {
  const std::vector<TradeOff> points{{1, 0, 1e6}, {1.1, 0, 10}, {1.5, 0, 5}, {2, 0, 1}};
  EXPECT_EQ(pareto_knee(points), 1u);
}

TEST(Pareto, OfTwoPointsTheKneeIsTheOneThatPays) {
  EXPECT_EQ(pareto_knee(std::vector<TradeOff>{{1, 0, 100}, {2, 0, 1}}), 1u);
  EXPECT_EQ(pareto_knee(std::vector<TradeOff>{{1, 0, 100}, {2, 0, 90}}), 0u);
  EXPECT_EQ(pareto_knee(std::vector<TradeOff>{{1, 0, 100}}), 0u);
  EXPECT_EQ(pareto_knee(std::vector<TradeOff>{}), std::nullopt);
}

TEST(Pareto, MediansAndTheirDeviations) {
  EXPECT_EQ(median_of(std::vector{3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median_of(std::vector{4.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_EQ(median_absolute_deviation(std::vector{1.0, 2.0, 3.0, 100.0, 2.0}), 1.0);
  EXPECT_EQ(median_absolute_deviation(std::vector<double>{}), 0.0);
}

}  // namespace
}  // namespace bspview
