#include "core/eval/lambda.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(Summarise, GivesTheMedianAndHalfTheDistanceOfTheQuartiles) {
  EXPECT_EQ(summarise({5, 1, 4, 2, 3}), (Measured{3.0, 1.0, 5}));
  EXPECT_EQ(summarise({4, 1, 3, 2}), (Measured{2.5, 0.75, 4}));
}

TEST(Summarise, OneValueHasNoSpreadAndNoValueNoRepeats) {
  EXPECT_EQ(summarise({7}), (Measured{7.0, 0.0, 1}));
  EXPECT_EQ(summarise({}), Measured{});
}

TEST(Summarise, OneOutlierMovesNeitherMedianNorSpreadFar) {
  EXPECT_EQ(summarise({1, 1, 1, 1, 100}), (Measured{1.0, 0.0, 5}));
}

}  // namespace
}  // namespace bspview
