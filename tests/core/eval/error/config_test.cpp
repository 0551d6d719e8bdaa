#include "core/eval/error/config.h"

#include <gtest/gtest.h>

#include <set>

namespace bspview {
namespace {

const ErrorDesign design(Traversal::robust, Builder::sah);

TEST(ErrorConfig, TheAnchorsComeFirst) {
  const std::vector<Levels> all = design.one_at_a_time();
  EXPECT_EQ(design.config(all[0]).name, "fast");
  EXPECT_EQ(design.config(all[1]).name, "default");
  EXPECT_EQ(design.config(all[1]).choice, KernelChoice{});
  EXPECT_EQ(design.config(all[1]).builder, Builder::sah);
}

TEST(ErrorConfig, EveryOtherDiffersFromAnAnchorInOneFactor) {
  const std::vector<Levels> all = design.one_at_a_time();
  // 3 + 2 + 1 + 1 + 1 other levels for each anchor.
  EXPECT_EQ(all.size(), 2u + 2u * 8u);
  for (std::size_t i = 2; i < all.size(); ++i) {
    EXPECT_TRUE(only_difference(all[i], design.fast()) ||
                only_difference(all[i], design.accurate()));
  }
}

TEST(ErrorConfig, CombinationsHaveEveryLevelOfTheirFactors) {
  const std::vector<Factor> factors{Factor::faces, Factor::quadrics, Factor::traversal};
  const std::vector<Levels> all = design.combinations(factors);
  EXPECT_EQ(std::set<Levels>(all.begin(), all.end()).size(), 4u * 2u * 3u);
  for (const Levels& levels : all) EXPECT_EQ(design.config(levels).builder, Builder::sah);
}

TEST(ErrorConfig, NamesSayWhatDiffersFromTheNearerAnchor) {
  Levels levels = design.fast();
  levels[static_cast<std::size_t>(Factor::quadrics)] = 1;
  EXPECT_EQ(design.config(levels).name, "fast + double quadrics");
  levels = design.accurate();
  levels[static_cast<std::size_t>(Factor::tree)] = 1;
  EXPECT_EQ(design.config(levels).name, "default + median tree");
}

TEST(ErrorConfig, ABuilderThatIsAskedForIsThatOfTheDefault) {
  const ErrorDesign other(Traversal::havran, Builder::mb);
  EXPECT_EQ(other.level_count(Factor::tree), 3);
  const ErrorConfig config = other.config(other.accurate());
  EXPECT_EQ(config.builder, Builder::mb);
  EXPECT_EQ(config.choice->traversal, Traversal::havran);
}

TEST(ErrorConfig, NamesAreTheirOwn) {
  std::vector<Levels> all = design.one_at_a_time();
  add_levels(all,
             design.combinations(std::vector{Factor::faces, Factor::traversal, Factor::offset}));
  std::set<std::string> names;
  for (const Levels& levels : all) names.insert(design.config(levels).name);
  EXPECT_EQ(names.size(), all.size());
}

}  // namespace
}  // namespace bspview
