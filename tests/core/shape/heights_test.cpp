#include "core/shape/heights.h"

#include <gtest/gtest.h>

#include "tests/support/instruction_sets.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

class HeightsTest : public testing::TestWithParam<std::int64_t> {
  test::OneInstructionSet set_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(EverySet, HeightsTest, testing::ValuesIn(test::instruction_sets()),
                         [](const auto& set) { return hwy::TargetName(set.param); });

TEST_P(HeightsTest, AreThoseOfPointAfterPointOnEveryAxis) {
  test::Random random(1);
  for (std::size_t count = 0; count <= Heights::most; ++count) {
    std::vector<Vec3> points(count);
    for (Vec3& point : points) point = random.point(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const float height = random.between(-0.5f, 0.5f);
      const Heights found = heights_of(points, axis, height);
      float nearest = std::numeric_limits<float>::infinity();
      for (std::size_t i = 0; i < count; ++i) {
        const float over = points[i][axis] - height;
        nearest = std::min(nearest, std::abs(over));
        ASSERT_EQ((found.below >> i & 1) != 0, over < 0.0f) << count << ", axis " << axis;
      }
      ASSERT_EQ(found.nearest, nearest) << count << ", axis " << axis;
      ASSERT_EQ(count < 64 ? found.below >> count : 0u, 0u) << count;
    }
  }
}

TEST_P(HeightsTest, APointAtTheHeightIsNotBelow) {
  const std::vector<Vec3> points(20, Vec3(0.25f));
  const Heights found = heights_of(points, 1, 0.25f);
  EXPECT_EQ(found.below, 0u);
  EXPECT_EQ(found.nearest, 0.0f);
}

}  // namespace
}  // namespace bspview
