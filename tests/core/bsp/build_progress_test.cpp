#include <gtest/gtest.h>

#include <mutex>
#include <numeric>

#include "core/bsp/cut.h"
#include "tests/support/box_sets.h"
#include "tests/support/builds.h"

namespace bspview {
namespace {

using test::BoxSet;

/// What a build tells.
struct Told {
  std::mutex mutex;
  std::vector<double> shares;

  Watch watch() {
    Watch watch;
    watch.progress = [this](double more) {
      const std::lock_guard lock(mutex);
      shares.push_back(more);
    };
    return watch;
  }
  double sum() const { return std::accumulate(shares.begin(), shares.end(), 0.0); }
  bool only_grows() const {
    return std::all_of(shares.begin(), shares.end(), [](double more) { return more >= 0.0; });
  }
};

constexpr double rounding = 1e-9;

TEST(BuildProgress, AddsUpToOneForEveryBuilderAndChangesNoTree) {
  const BoxSet set = test::random_boxes(20'000, 1);
  for (const BuildParams& params : test::every_way({.threads = 2})) {
    SCOPED_TRACE(test::describe(params));
    Told told;
    const auto tree = build_tree(set.input(), params, told.watch());
    ASSERT_TRUE(tree.ok());
    test::expect_same(*tree, *build_tree(set.input(), params));
    EXPECT_NEAR(told.sum(), 1.0, rounding);
    EXPECT_TRUE(told.only_grows());
  }
}

TEST(BuildProgress, IsToldInSmallPartsButSeldom) {
  const BoxSet set = test::random_boxes(50'000, 2);
  for (const Builder builder : {Builder::median, Builder::mb, Builder::sah, Builder::sah_binned}) {
    Told told;
    ASSERT_TRUE(build_tree(set.input(), {.builder = builder}, told.watch()).ok());
    EXPECT_LT(*std::ranges::max_element(told.shares), 0.3);
    EXPECT_GT(told.shares.size(), 100u);
    EXPECT_LT(told.shares.size(), 4000u);
  }
}

TEST(BuildProgress, EndsWhereTheTreeIsCutShort) {
  const BoxSet set = test::random_boxes(5000, 3);
  for (const BuildParams& params : {BuildParams{.max_depth = 0}, BuildParams{.max_depth = 3}}) {
    Told told;
    ASSERT_TRUE(build_tree(set.input(), params, told.watch()).ok());
    EXPECT_NEAR(told.sum(), 1.0, rounding);
    EXPECT_TRUE(told.only_grows());
  }
}

TEST(BuildProgress, BeginsAgainOnceWhereTheMemoryLimitIsPassed) {
  const BoxSet set = test::random_boxes(20'000, 3);
  const std::size_t bytes = build_tree(set.input(), {})->bytes();
  for (const std::size_t limit : {std::size_t{0}, std::size_t{20'000}, bytes / 2, bytes - 1}) {
    for (const int threads : {1, 2}) {
      const BuildParams params{.memory_limit = limit, .threads = threads};
      Told told;
      const auto tree = build_tree(set.input(), params, told.watch());
      ASSERT_TRUE(tree.ok());
      EXPECT_TRUE(tree->memory_limit_reached);
      test::expect_same(*tree, *build_tree(set.input(), params));
      EXPECT_NEAR(told.sum(), 1.0, rounding);
      const auto is_back = [](double more) { return more < 0.0; };
      const auto back = std::ranges::find_if(told.shares, is_back);
      ASSERT_NE(back, told.shares.end());
      EXPECT_NEAR(std::accumulate(told.shares.begin(), back + 1, 0.0), 0.0, rounding);
      EXPECT_EQ(std::ranges::count_if(told.shares, is_back), 1);
      EXPECT_LT(*std::max_element(back, told.shares.end()), 0.9);
    }
  }
}

TEST(BuildProgress, EndsWithoutObjects) {
  Told told;
  ASSERT_TRUE(build_tree({}, {}, told.watch()).ok());
  EXPECT_NEAR(told.sum(), 1.0, rounding);
}

TEST(BuildProgress, IsToldOfTreesToCutFrom) {
  const BoxSet set = test::random_boxes(5000, 4);
  Told told;
  const InnerLimit limit{std::size_t{1} << 30};
  ASSERT_TRUE(build_maximal_tree(set.input(), {}, limit, told.watch()).ok());
  EXPECT_NEAR(told.sum(), 1.0, rounding);
}

}  // namespace
}  // namespace bspview
