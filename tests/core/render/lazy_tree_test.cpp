#include "core/render/lazy_tree.h"

#include <gtest/gtest.h>

#include "core/bsp/stats.h"
#include "core/bsp/validate.h"
#include "core/render/hits.h"
#include "core/render/lazy_walk.h"
#include "core/render/render.h"
#include "core/scene/spd.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::Random;

RenderParams small_picture(int threads = 0) {
  return {.width = 40, .height = 32, .threads = threads};
}

Image eager_picture(const Scene& scene, const BuildParams& build, const RenderParams& picture) {
  const auto tree = build_scene_tree(scene, build);
  const FastWorld fast({scene, *tree});
  return *render_image(fast.world(), scene.camera, picture);
}

std::shared_ptr<const LazyTree> lazy_tree(const Scene& scene, const BuildParams& build) {
  auto lazy = LazyTree::build(scene, build);
  EXPECT_TRUE(lazy.ok());
  return *lazy;
}

std::size_t unbuilt_references(const Tree& tree) {
  std::size_t sum = 0;
  for (const std::uint32_t leaf : tree.unbuilt) sum += tree.nodes[leaf].count();
  return sum;
}

std::vector<Builder> growing_builders() {
  std::vector<Builder> builders;
  for (std::size_t i = 1; i < builder_names().size(); ++i) {
    builders.push_back(static_cast<Builder>(i));
  }
  return builders;
}

TEST(LazyTree, PicturesOfAllStandardScenesAreThoseOfWholeTrees) {
  for (const SpdScene& spd : spd_scenes()) {
    const auto scene = make_spd(spd.name);
    ASSERT_TRUE(scene.ok());
    const Image whole = eager_picture(*scene, {}, small_picture());
    const auto lazy = lazy_tree(*scene, {});
    const World world = lazy->world();
    EXPECT_EQ(*render_image(world, scene->camera, small_picture()), whole) << spd.name;
    EXPECT_EQ(*render_image(world, scene->camera, small_picture()), whole) << spd.name << " again";
  }
}

TEST(LazyTree, PicturesDoNotDependOnBuilderOrThreads) {
  const Scene scene = test::random_scene(3000, 5);
  const Image whole = eager_picture(scene, {}, small_picture());
  for (const Builder builder : growing_builders()) {
    for (const int threads : {1, 2, 7}) {
      const auto lazy = lazy_tree(scene, {.builder = builder, .threads = threads});
      EXPECT_EQ(*render_image(lazy->world(), scene.camera, small_picture(threads)), whole)
          << name_of(builder) << ", " << threads << " threads";
    }
  }
}

/// Rays of every kind that wide nodes take and that they do not.
std::vector<Ray> mixed_rays(int count) {
  Random random(11);
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    Ray ray{.origin = random.point(2.0f), .direction = random.direction()};
    if (i % 3 == 0) ray.t_max = random.between(0.5f, 4.0f);
    if (i % 5 == 0) ray.t_min = -1.0f;
    if (i % 7 == 0) ray.direction *= 1e9f;
    if (i % 11 == 0) ray.direction.x = 0.0f;
    if (i % 101 == 0) ray.direction = Vec3(0.0f);
    rays.push_back(ray);
  }
  return rays;
}

TEST(LazyTree, RaysAreAnsweredAsByTheWholeTree) {
  const Scene scene = test::random_scene(5000, 9);
  const auto tree = build_scene_tree(scene, {});
  const World whole{scene, *tree};
  const std::vector<Ray> rays = mixed_rays(3000);
  for (const bool together : {false, true}) {
    const auto lazy = lazy_tree(scene, {});
    const World world = lazy->world();
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint32_t> found(rays.size());
    if (together) {
      closest_hits(world, rays, SideRule::two_sided, hits);
      any_hits(world, rays, SideRule::two_sided, found);
    }
    NoObserver none;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!together) {
        hits[i] = fast_closest_hit(world, rays[i], SideRule::two_sided);
        found[i] = fast_any_hit(world, rays[i], SideRule::two_sided);
      }
      const Hit expected = closest_hit(whole, rays[i], {}, none);
      ASSERT_EQ(hits[i].object, expected.object) << "ray " << i;
      ASSERT_EQ(hits[i].t, expected.t) << "ray " << i;
      ASSERT_EQ(found[i] != no_index, static_cast<bool>(expected)) << "ray " << i;
    }
  }
}

TEST(LazyTree, WhatNoRayCameToIsNotBuiltAndMarked) {
  const Scene scene = test::random_triangles(20000, 3);
  const auto lazy = lazy_tree(scene, {});
  const Tree before = *lazy->graft();
  EXPECT_GT(unbuilt_references(before), 19000u);
  const Ray ray{.origin = Vec3(-3.0f, 0.1f, 0.2f), .direction = Vec3(1.0f, 0.0f, 0.0f)};
  find_in_parts(lazy->world(), ray, SideRule::two_sided, false);
  const Tree after = *lazy->graft();
  EXPECT_GT(after.nodes.size(), before.nodes.size());
  EXPECT_GT(unbuilt_references(after), 10000u);
  for (const Tree* tree : {&before, &after}) {
    EXPECT_TRUE(std::ranges::is_sorted(tree->unbuilt));
    for (const std::uint32_t leaf : tree->unbuilt) EXPECT_TRUE(tree->nodes[leaf].is_leaf());
    const SceneBuildInput objects(scene);
    const auto valid = validate(*tree, objects.input());
    EXPECT_TRUE(valid.ok()) << valid.error().message;
  }
}

/// Every builder but sah, which bins wide nodes of trees that grow.
TEST(LazyTree, CountsAreThoseOfTheWholeTree) {
  const Scene scene = test::random_scene(4000, 21);
  for (const Builder builder : growing_builders()) {
    if (builder == Builder::sah) continue;
    const BuildParams build{.builder = builder};
    const auto whole = build_scene_tree(scene, build);
    const auto expected = render_counted({scene, *whole}, scene.camera, small_picture());
    const auto lazy = lazy_tree(scene, build);
    ASSERT_TRUE(build_for_counts(lazy->world(), scene.camera, small_picture()).ok());
    const auto grown = lazy->graft();
    const auto counted = render_counted({scene, *grown}, scene.camera, small_picture());
    EXPECT_EQ(counted->counts, expected->counts) << name_of(builder);
    EXPECT_EQ(counted->image, expected->image) << name_of(builder);
  }
}

TEST(LazyTree, APartWithoutMemoryIsTestedAsALeaf) {
  const Scene scene = test::random_triangles(20000, 4);
  const Image whole = eager_picture(scene, {}, small_picture());
  const std::size_t upper = lazy_tree(scene, {})->world().tree.bytes();
  for (const std::size_t more : {std::size_t{0}, std::size_t{1} << 12, std::size_t{1} << 16}) {
    const BuildParams build{.memory_limit = upper + more};
    const auto lazy = lazy_tree(scene, build);
    EXPECT_EQ(*render_image(lazy->world(), scene.camera, small_picture()), whole);
    ASSERT_TRUE(build_for_counts(lazy->world(), scene.camera, small_picture()).ok());
    const auto tree = lazy->graft();
    EXPECT_TRUE(tree->memory_limit_reached) << more;
    EXPECT_LE(tree->bytes(), build.memory_limit + 4096) << more;
  }
}

TEST(LazyTree, AStopEndsTheUpperPartAndPictures) {
  const Scene scene = test::random_triangles(20000, 6);
  std::stop_source source;
  source.request_stop();
  const auto stopped = LazyTree::build(scene, {}, source.get_token());
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().message, "stopped");
  const auto lazy = lazy_tree(scene, {});
  const auto picture =
      render_image(lazy->world(), scene.camera, small_picture(), Watch(source.get_token()));
  ASSERT_FALSE(picture.ok());
  EXPECT_EQ(picture.error().message, "stopped");
  EXPECT_EQ(*render_image(lazy->world(), scene.camera, small_picture()),
            eager_picture(scene, {}, small_picture()));
}

TEST(LazyTree, ScenesOfFewOrOddObjectsHaveTrees) {
  for (const int count : {0, 1, 2, 70}) {
    Scene scene = test::random_triangles(count, 8);
    if (count == 2) {
      for (int i = 0; i < 300; ++i) add_sphere(scene, 0, {Vec3(0.0f), 1.0f});  // all the same
    }
    const auto lazy = lazy_tree(scene, {});
    EXPECT_EQ(*render_image(lazy->world(), scene.camera, small_picture()),
              eager_picture(scene, {}, small_picture()))
        << count;
    EXPECT_TRUE(build_for_counts(lazy->world(), scene.camera, small_picture()).ok());
    EXPECT_TRUE(lazy->graft().ok());
  }
}

}  // namespace
}  // namespace bspview
