#include "core/eval/error/judge.h"

#include <gtest/gtest.h>

#include "core/eval/error/offset.h"
#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// Scene, tree, reference and recorded rays.
class ErrorJudge : public ::testing::Test {
 protected:
  void prepare(Scene one) {
    scene = std::move(one);
    tree = *build_scene_tree(scene, {});
    reference.emplace(scene);
    batches = *record_batches(World{scene, tree}, {.rays = 2000, .threads = 2, .seed = 3});
  }
  World world() const { return {scene, tree}; }
  JudgedScene judged() const { return {world(), *reference, batches, 2}; }
  BoundKernel bind(const KernelChoice& choice) const {
    ErrorConfig config;
    config.kernel = make_kernel(choice);
    config.choice = choice;
    return {config, world()};
  }
  ErrorCounts judge(const BoundKernel& kernel) const {
    return judge_hits(judged(), std::span(&kernel, 1)).front();
  }

  Scene scene;
  Tree tree;
  std::optional<Reference> reference;
  std::vector<RayBatch> batches;
};

/// Answers as `change` makes of the default's.
BoundKernel changed(const BoundKernel& own, const std::function<void(RayResult&)>& change) {
  BoundKernel kernel = own;
  kernel.closest = [own, change](std::span<const Ray> rays, std::span<RayResult> results) {
    own.closest(rays, results);
    for (RayResult& result : results) change(result);
  };
  return kernel;
}

TEST_F(ErrorJudge, TheDefaultIsRightEverywhere) {
  for (const Scene& one : {test::random_scene(400, 5), test::random_triangles(400, 6)}) {
    prepare(one);
    const ErrorCounts counts = judge(bind({}));
    EXPECT_GT(counts.ordinary().rays, 1000u);
    EXPECT_EQ(counts.ordinary().wrong(), 0u);
    EXPECT_EQ(counts.aimed().wrong(), 0u);
    EXPECT_LE(counts.t_error.largest(), 1.0);
  }
}

TEST_F(ErrorJudge, LostPhantomAndShiftedAnswersAreTold) {
  prepare(test::random_scene(400, 5));
  const HitCounts right = judge(bind({})).hits[0];
  const HitCounts lost = judge(changed(bind({}), [](RayResult& hit) { hit = {}; })).hits[0];
  EXPECT_GT(lost.lost, 100u);
  EXPECT_EQ(lost.rays, right.rays);
  const ErrorCounts other = judge(changed(bind({}), [](RayResult& hit) {
    if (hit.object != no_index) hit.object = hit.object == 0 ? 1 : hit.object - 1;
  }));
  EXPECT_EQ(other.hits[0].wrong(), lost.lost);
  EXPECT_GT(other.hits[0].phantom, 100u);
  const ErrorCounts shifted =
      judge(changed(bind({}), [](RayResult& hit) { hit.t *= 1.0 + 0x1p-20; }));
  EXPECT_EQ(shifted.hits[0].wrong(), 0u);
  EXPECT_NEAR(shifted.t_error.quantile(0.5), 12.0, 5.0);  // 2^-20 is 8 to 16 ulp of float
}

TEST_F(ErrorJudge, ShadowRaysAreJudgedByWhetherTheyHit) {
  prepare(test::random_scene(400, 5));
  BoundKernel blind = bind({});
  blind.occluded = [](std::span<const Ray>, std::span<char> results) {
    std::ranges::fill(results, char{0});
  };
  const HitCounts counts = judge(blind).hits[static_cast<std::size_t>(RayGroup::shadow)];
  EXPECT_GT(counts.lost, 10u);
  EXPECT_EQ(counts.phantom, 0u);
}

TEST_F(ErrorJudge, AClosedMeshLeaksUnderTextbookFloatAlone) {
  prepare(test::cube_grid(8, {0.1f, 0.2f, 0.3f}));
  EXPECT_TRUE(has_only_triangles(scene));
  EXPECT_EQ(judge(bind({})).aimed().leaks, 0u);
  EXPECT_EQ(judge(bind({.faces = FaceTest::woop_float})).aimed().leaks, 0u);
  EXPECT_GT(judge(bind({.faces = FaceTest::moeller_float})).aimed().leaks, 0u);
}

TEST_F(ErrorJudge, LosingARimIsNoLeak) {
  prepare(test::cube_grid(2, Vec3(0.0f)));
  // Through two faces that meet at x = z = 1, close to the edge, and through the middle.
  EXPECT_FALSE(leaks_at(judged(), {{1.0f, 0.2f, 2.0f - 1e-5f}, {1.0f, 0.0f, -1.0f}}));
  EXPECT_FALSE(leaks_at(judged(), {{0.0f, 0.2f, 2.0f - 1e-5f}, {1.0f, 0.0f, -1.0f}}));
  EXPECT_TRUE(leaks_at(judged(), {{0.2f, 0.2f, 2.0f}, {0.1f, 0.0f, -1.0f}}));
}

TEST_F(ErrorJudge, TheThreadsDoNotChangeTheCounts) {
  prepare(test::random_triangles(300, 6));
  const BoundKernel kernel = bind({.faces = FaceTest::moeller_float});
  JudgedScene one = judged();
  one.threads = 1;
  EXPECT_EQ(judge_hits(one, std::span(&kernel, 1)).front(), judge(kernel));
}

TEST_F(ErrorJudge, TheBoundedOffsetHasNeitherAcneNorLeaks) {
  prepare(test::random_scene(600, 7));
  const BoundKernel kernel = bind({});
  const OffsetCounts counts = judge_offsets(judged(), std::span(&kernel, 1), 1).front();
  EXPECT_GT(counts.leaving, 300u);
  EXPECT_GT(counts.hidden, 10u);
  EXPECT_EQ(counts.acne, 0u);
  EXPECT_EQ(counts.leaks, 0u);
}

TEST_F(ErrorJudge, AFixedMinimumFailsFarFromTheOrigin) {
  prepare(test::random_scene(600, 7, Vec3(20000.0f)));
  const BoundKernel fixed = bind({.offset = OffsetRule::fixed}), bounded = bind({});
  const OffsetCounts counts = judge_offsets(judged(), std::span(&fixed, 1), 1).front();
  EXPECT_GT(counts.acne, counts.leaving / 20);
  EXPECT_EQ(judge_offsets(judged(), std::span(&bounded, 1), 1).front().acne, 0u);
}

TEST_F(ErrorJudge, EqualSeedsRecordEqualRays) {
  prepare(test::random_triangles(200, 8));
  const auto again = *record_batches(world(), {.rays = 2000, .threads = 1, .seed = 3});
  ASSERT_EQ(again.size(), batches.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].group, batches[i].group);
    EXPECT_EQ(again[i].rays, batches[i].rays);
    EXPECT_LE(again[i].rays.size(), 2000u + 100u);
  }
}

TEST(UlpHistogram, QuantilesAreRightToFivePercent) {
  UlpHistogram histogram;
  for (int i = 1; i <= 10000; ++i) histogram.add(i * 0.01);
  EXPECT_NEAR(histogram.quantile(0.5), 50.0, 2.5);
  EXPECT_NEAR(histogram.quantile(0.999), 99.9, 5.0);
  EXPECT_EQ(histogram.largest(), 100.0);
  EXPECT_EQ(histogram.count(), 10000u);
  UlpHistogram exact;
  exact.add(0.0);
  EXPECT_EQ(exact.quantile(0.5), 0.0);
}

}  // namespace
}  // namespace bspview
