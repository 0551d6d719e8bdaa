// Ray counts of the standard scenes against those published by Havran (1999), which no tree can
// change; his ray tracer is another, so within 10 %.

#include <gtest/gtest.h>

#include "core/render/render.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

struct Published {
  const char* scene;
  double primary_hits, shadow, secondary, all, minimal_tests;
};

class SpdCounts : public testing::TestWithParam<Published> {};

TEST_P(SpdCounts, AreWithinTenPercentOfThePublishedOnes) {
  const Published& published = GetParam();
  const auto scene = make_spd(published.scene);
  ASSERT_TRUE(scene.ok());
  const auto tree = build_scene_tree(*scene, {});
  ASSERT_TRUE(tree.ok());
  RenderParams params;
  params.spd_rules = true;
  const auto picture = render_counted({*scene, *tree}, scene->camera, params);
  ASSERT_TRUE(picture.ok());
  const RayCounts& counts = picture->counts;
  const auto near = [](std::uint64_t count, double expected) {
    return std::abs(static_cast<double>(count) - expected) <= 0.1 * expected;
  };
  EXPECT_EQ(counts.primary, 513u * 513u);
  EXPECT_TRUE(near(counts.primary_hits, published.primary_hits)) << counts.primary_hits;
  EXPECT_TRUE(near(counts.shadow, published.shadow)) << counts.shadow;
  EXPECT_TRUE(near(counts.secondary(), published.secondary)) << counts.secondary();
  EXPECT_TRUE(near(counts.all(), published.all)) << counts.all();
  EXPECT_TRUE(near(counts.minimal_tests(), published.minimal_tests)) << counts.minimal_tests();
}

INSTANTIATE_TEST_SUITE_P(
    Havran1999, SpdCounts,
    testing::Values(Published{"balls", 263169, 959244, 179884, 1402297, 682715},
                    Published{"gears", 245332, 2088012, 494338, 2845519, 1668227},
                    Published{"tetra", 49950, 46262, 0, 309431, 55488},
                    Published{"tree", 169907, 1110323, 0, 1373492, 217413}),
    [](const auto& test) { return std::string(test.param.scene); });

}  // namespace
}  // namespace bspview
