#include "core/eval/cast.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "core/render/scene_tree.h"
#include "tests/support/brute_force.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

std::vector<Ray> random_rays(int count, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    rays.push_back({random.point(2.0f), random.between(0.01f, 50.0f) * random.direction()});
  }
  return rays;
}

TEST(Cast, EqualsBruteForceForEveryTraversal) {
  const Scene scene = test::random_scene(60, 5);
  const Tree tree = *build_scene_tree(scene, {});
  const std::vector<Ray> rays = random_rays(9000, 6);
  for (const auto traversal : {Traversal::sung_shirley, Traversal::havran, Traversal::robust}) {
    const auto results = cast_rays({scene, tree}, rays, {.traversal = traversal});
    const auto blocked =
        cast_rays({scene, tree}, rays, {.query = CastParams::Query::any, .traversal = traversal});
    ASSERT_EQ(results.size(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit expected = test::brute_force(scene, rays[i]);
      ASSERT_EQ(results[i], (RayResult{expected.object, expected.t})) << i;
      ASSERT_EQ(blocked[i].object != no_index, static_cast<bool>(expected)) << i;
    }
  }
}

TEST(Cast, ResultsDoNotDependOnTheNumberOfThreads) {
  const Scene scene = test::random_scene(60, 5);
  const Tree tree = *build_scene_tree(scene, {});
  const std::vector<Ray> rays = random_rays(20000, 7);
  EXPECT_EQ(cast_rays({scene, tree}, rays, {.threads = 1}),
            cast_rays({scene, tree}, rays, {.threads = 4}));
}

TEST(Cast, ProgressAddsUpToTheNumberOfRays) {
  const Scene scene = test::random_scene(10, 5);
  const Tree tree = *build_scene_tree(scene, {});
  for (const int count : {0, 1, 4096, 4097, 10000}) {
    std::atomic<std::size_t> done = 0;
    const std::vector<Ray> rays = random_rays(count, 8);
    const auto results = cast_rays({scene, tree}, rays, {}, [&](std::size_t n) { done += n; });
    EXPECT_EQ(done, static_cast<std::size_t>(count));
    EXPECT_EQ(results.size(), rays.size());
  }
}

}  // namespace
}  // namespace bspview
