// An allocation that fails at any moment of a build or a picture costs nothing but the result.

#include <gtest/gtest.h>

#include <new>

#include "core/bsp/cut.h"
#include "core/render/render.h"
#include "core/render/scene_tree.h"
#include "tests/memory/allocations.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::FailingAllocation;
using test::live_bytes;

constexpr int trials = 150;  // of each; together the 300 of a full run

/// Calls of operator new that `work` makes.
template <class Work>
long count_allocations(const Work& work) {
  const FailingAllocation none(-1);
  work();
  return none.calls();
}

TEST(AllocationFailure, ABuildGivesOneErrorAndEveryByteBack) {
  const Scene scene = test::random_scene(3000, 71);
  test::Random random(72);
  for (int trial = 0; trial < trials; ++trial) {
    const BuildParams params{.builder = static_cast<Builder>(1 + trial % 5), .max_depth = 12};
    const auto build = [&] { return build_scene_tree(scene, params); };
    const long all = count_allocations([&] { (void)build(); });
    const std::ptrdiff_t before = live_bytes();
    std::string outcome;
    {
      const FailingAllocation failing(random.below(static_cast<int>(all)));
      try {
        const auto tree = build();
        outcome = tree ? "a tree" : "an error";
        if (!tree) {
          EXPECT_EQ(tree.error().message, "not enough memory for the tree");
        }
      } catch (const std::bad_alloc&) {
        outcome = "an exception";
      }
    }
    EXPECT_NE(outcome, "an exception") << name_of(params.builder) << ", trial " << trial;
    EXPECT_EQ(live_bytes(), before) << name_of(params.builder) << ", trial " << trial;
  }
}

TEST(AllocationFailure, AMaximalTreeGivesOneErrorAndEveryByteBack) {
  const Scene scene = test::random_scene(3000, 75);
  const SceneBuildInput objects(scene);
  const auto build = [&] {
    return build_maximal_tree(objects.input(), {.max_depth = 12}, {std::size_t{1} << 26});
  };
  const long all = count_allocations([&] { (void)build(); });
  test::Random random(76);
  for (int trial = 0; trial < trials; ++trial) {
    const std::ptrdiff_t before = live_bytes();
    {
      const FailingAllocation failing(random.below(static_cast<int>(all)));
      const auto whole = build();
      if (!whole) {
        EXPECT_EQ(whole.error().message, "not enough memory for the tree") << trial;
      }
    }
    EXPECT_EQ(live_bytes(), before) << trial;
  }
}

TEST(AllocationFailure, ACutGivesNothingAndTheMaximalTreeStays) {
  const Scene scene = test::random_scene(3000, 77);
  const SceneBuildInput objects(scene);
  const auto whole = build_maximal_tree(objects.input(), {}, {std::size_t{1} << 26});
  ASSERT_TRUE(whole.ok());
  const BuildParams params{.leaf_size = 3};
  const auto part = cut(*whole, params);
  const long all = count_allocations([&] { (void)cut(*whole, params); });
  for (long i = 0; i < all; ++i) {
    const std::ptrdiff_t before = live_bytes();
    {
      const FailingAllocation failing(i);
      EXPECT_FALSE(cut(*whole, params)) << i;
    }
    EXPECT_EQ(live_bytes(), before) << i;
  }
  EXPECT_EQ(cut(*whole, params)->nodes, part->nodes);
}

TEST(AllocationFailure, APictureGivesOneErrorAndEveryByteBackAndTheTreeStays) {
  const Scene scene = test::random_scene(500, 73);
  const auto tree = build_scene_tree(scene, {});
  ASSERT_TRUE(tree.ok());
  const Tree copy = *tree;
  const RenderParams params{.width = 48, .height = 48};
  const auto whole = render_image({scene, *tree}, scene.camera, params);
  const long all = count_allocations([&] {
    (void)render_image({scene, *tree}, scene.camera, params);
  });
  test::Random random(74);
  for (int trial = 0; trial < trials; ++trial) {
    const std::ptrdiff_t before = live_bytes();
    {
      const FailingAllocation failing(random.below(static_cast<int>(all)));
      const auto image = render_image({scene, *tree}, scene.camera, params);
      if (image) {
        EXPECT_EQ(*image, *whole) << trial;
      } else {
        EXPECT_EQ(image.error().message, "not enough memory for the picture") << trial;
      }
    }
    EXPECT_EQ(live_bytes(), before) << trial;
  }
  EXPECT_EQ(tree->nodes, copy.nodes);
  EXPECT_EQ(tree->references, copy.references);
}

}  // namespace
}  // namespace bspview
