#include "core/eval/kernels.h"

#include <gtest/gtest.h>

#include <set>

#include "core/render/scene_tree.h"
#include "tests/support/brute_force.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

std::vector<KernelChoice> every_choice() {
  std::vector<KernelChoice> choices;
  for (int faces = 0; faces < 4; ++faces) {
    for (int quadrics = 0; quadrics < 2; ++quadrics) {
      for (int traversal = 0; traversal < 3; ++traversal) {
        for (int offset = 0; offset < 2; ++offset) {
          choices.push_back({static_cast<FaceTest>(faces), static_cast<QuadricTest>(quadrics),
                             static_cast<Traversal>(traversal), static_cast<OffsetRule>(offset)});
        }
      }
    }
  }
  return choices;
}

std::vector<Ray> random_rays(int count, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 origin = random.point(3.0f);
    rays.push_back({origin, random.point(1.0f) - origin});
  }
  return rays;
}

class Kernels : public ::testing::Test {
 protected:
  Scene scene = test::random_scene(300, 1);
  Tree tree = *build_scene_tree(scene, {});
  World world{scene, tree};
  std::vector<Ray> rays = random_rays(2000, 2);

  std::vector<RayResult> closest(const Kernel& kernel) const {
    std::vector<RayResult> results(rays.size());
    kernel.closest(world)(rays, results);
    return results;
  }
};

TEST_F(Kernels, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (const KernelChoice& choice : every_choice()) names.insert(make_kernel(choice).name);
  EXPECT_EQ(names.size(), every_choice().size());
}

TEST_F(Kernels, TheDefaultAnswersAsPicturesDo) {
  const std::vector<RayResult> results = closest(make_kernel({}));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit hit = test::brute_force(scene, rays[i]);
    EXPECT_EQ(results[i], (RayResult{hit.object, hit.t})) << i;
  }
}

TEST_F(Kernels, WhereNothingIsCloseAllAgreeUpToRounding) {
  const std::vector<RayResult> expected = closest(make_kernel({}));
  std::size_t hits = 0;
  for (const RayResult& result : expected) hits += result.object != no_index;
  EXPECT_GT(hits, rays.size() / 10);
  for (const KernelChoice& choice : every_choice()) {
    const Kernel kernel = make_kernel(choice);
    const std::vector<RayResult> results = closest(kernel);
    int others = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      others += results[i].object != expected[i].object;
      if (results[i].object != expected[i].object || expected[i].object == no_index) continue;
      EXPECT_NEAR(results[i].t, expected[i].t, 2e-4 * (1.0 + expected[i].t)) << kernel.name;
    }
    EXPECT_LE(others, 4) << kernel.name;
  }
}

TEST_F(Kernels, OcclusionIsWhetherTheClosestHitExists) {
  for (const KernelChoice& choice : every_choice()) {
    const Kernel kernel = make_kernel(choice);
    const std::vector<RayResult> hits = closest(kernel);
    std::vector<char> occluded(rays.size());
    kernel.occluded(world)(rays, occluded);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(occluded[i] != 0, hits[i].object != no_index) << kernel.name << " ray " << i;
    }
  }
}

TEST_F(Kernels, AFixedMinimumHidesWhatIsNearer) {
  Scene near;
  add_sphere(near, add_material(near, {}), {Vec3(0.0f), 1.0f});
  const Tree near_tree = *build_scene_tree(near, {});
  const std::vector<Ray> touching{{{0.0f, 0.0f, -1.00001f}, {0.0f, 0.0f, 1.0f}}};
  std::vector<RayResult> result(1);
  make_kernel({}).closest({near, near_tree})(touching, result);
  EXPECT_NEAR(result[0].t, 1e-5, 1e-7);
  make_kernel({.offset = OffsetRule::fixed}).closest({near, near_tree})(touching, result);
  EXPECT_NEAR(result[0].t, 2.0, 1e-4);
}

}  // namespace
}  // namespace bspview
