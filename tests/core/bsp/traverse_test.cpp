#include "core/bsp/traverse.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/render/intersect.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/brute_force.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::Random;

constexpr std::array builders{Builder::naive,         Builder::median, Builder::median_longest,
                              Builder::object_median, Builder::mb,     Builder::sah,
                              Builder::sah_binned};
constexpr std::array traversals{Traversal::sung_shirley, Traversal::havran, Traversal::robust};

Tree build(const Scene& scene, Builder builder, int leaf_size = 2) {
  BuildParams params;
  params.builder = builder;
  params.leaf_size = leaf_size;
  params.max_depth = 14;
  auto tree = build_scene_tree(scene, params);
  EXPECT_TRUE(tree.ok());
  return std::move(*tree);
}

Hit trace(const Scene& scene, const Tree& tree, const Ray& ray,
          Traversal traversal = Traversal::robust) {
  NoObserver none;
  return closest_hit({scene, tree}, ray, {.traversal = traversal}, none);
}

bool occluded(const Scene& scene, const Tree& tree, const Ray& ray) {
  NoObserver none;
  return any_hit({scene, tree}, ray, {}, none) != no_index;
}

/// Rays that start and end in and around the cube of side 2 about `centre`.
std::vector<Ray> random_rays(int count, std::uint64_t seed, Vec3 centre = Vec3(0.0f)) {
  Random random(seed);
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 origin = centre + random.point(i % 2 == 0 ? 1.0f : 3.0f);
    rays.push_back({origin, centre + random.point(1.0f) - origin});
  }
  return rays;
}

/// Rays aimed at a point of a random edge of a random face: where neighbours and cells meet.
std::vector<Ray> edge_rays(const Scene& scene, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray> rays;
  const Aabb box = scene_bounds(scene);
  for (int i = 0; i < count; ++i) {
    const auto face = static_cast<std::size_t>(random.below(static_cast<int>(scene.faces.size())));
    const auto vertices = vertices_of(scene, scene.faces[face]);
    const auto corner = static_cast<std::size_t>(random.below(static_cast<int>(vertices.size())));
    const Vec3 a = vertices[corner], b = vertices[(corner + 1) % vertices.size()];
    const float s = random.below(4) == 0 ? 0.0f : random.unit();
    const Vec3 origin = box.centre() + random.point(3.0f);
    rays.push_back({origin, a + s * (b - a) - origin});
  }
  return rays;
}

/// The ray's bits, to reproduce it.
std::string print(const Ray& ray) {
  return fmt::format("origin {:a} {:a} {:a} direction {:a} {:a} {:a}", ray.origin.x, ray.origin.y,
                     ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z);
}

void expect_brute_force(const Scene& scene, const Tree& tree, std::span<const Ray> rays,
                        Traversal traversal = Traversal::robust) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit expected = test::brute_force(scene, rays[i]);
    const Hit found = trace(scene, tree, rays[i], traversal);
    ASSERT_EQ(found.object, expected.object) << print(rays[i]) << " by " << name_of(traversal);
    ASSERT_EQ(found.t, expected.t) << print(rays[i]) << " by " << name_of(traversal);
  }
}

TEST(Traverse, EveryBuilderAndTraversalFindsWhatBruteForceFinds) {
  const Scene scene = test::random_scene(300, 21);
  const auto rays = random_rays(3000, 22);
  for (const Builder builder : builders) {
    const Tree tree = build(scene, builder);
    for (const Traversal traversal : traversals) {
      SCOPED_TRACE(name_of(builder));
      expect_brute_force(scene, tree, rays, traversal);
    }
  }
}

TEST(Traverse, SmallStandardScenesMatchBruteForceInEveryBuilder) {
  for (const char* name :
       {"balls", "gears", "lattice", "rings", "tetra", "tree", "mount", "jacks"}) {
    const auto scene = make_spd(name, name == std::string("lattice") ? 3 : 2);
    ASSERT_TRUE(scene.ok()) << name;
    const Aabb box = scene_bounds(*scene);
    Random random(23);
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) {
      const Vec3 target = box.lo + Vec3(random.unit(), random.unit(), random.unit()) * box.extent();
      rays.push_back({scene->camera.from, target - scene->camera.from});
    }
    for (const Builder builder : builders) {
      SCOPED_TRACE(std::string(name) + " " + std::string(name_of(builder)));
      expect_brute_force(*scene, build(*scene, builder), rays);
    }
  }
}

TEST(Traverse, RobustFindsEveryHitOnEdgesAndVerticesOfClosedMeshes) {
  for (const Vec3 centre : {Vec3(0.0f), Vec3(0.1f, 0.2f, 0.3f), Vec3(1000.0f)}) {
    const Scene scene = test::cube_grid(8, centre);
    const auto rays = edge_rays(scene, 20000, 24);
    for (const Builder builder : {Builder::median, Builder::object_median, Builder::sah}) {
      const Tree tree = build(scene, builder, 1);
      for (const Ray& ray : rays) {
        // From inside every ray hits; from outside one at the silhouette may pass by.
        const bool inside = scene_bounds(scene).contains(ray.origin);
        if (inside) {
          ASSERT_TRUE(trace(scene, tree, ray)) << name_of(builder);
        }
      }
      expect_brute_force(scene, tree, std::span(rays).first(2000));
    }
  }
}

TEST(Traverse, RobustMatchesBruteForceForRaysThatLieInPlanes) {
  const Scene scene = test::cube_grid(8, Vec3(0.0f));
  const Tree tree = build(scene, Builder::median, 1);
  constexpr std::array components{0.0f, -0.0f, 1.0f, -1.0f, 0.5f, 1e-45f, -1e-30f};
  Random random(25);
  std::vector<Ray> rays;
  for (int i = 0; i < 4000; ++i) {
    // Origins and directions on the planes of the grid, with zeros of both signs.
    Vec3 origin, direction;
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = -1.25f + 0.25f * static_cast<float>(random.below(11));
      direction[axis] = components[static_cast<std::size_t>(random.below(7))];
    }
    if (direction == Vec3(0.0f)) direction.x = 1.0f;
    rays.push_back({origin, direction});
  }
  expect_brute_force(scene, tree, rays);
}

TEST(Traverse, TinyAndHugeDirectionsFindTheSameObject) {
  const Scene scene = test::random_scene(300, 26);
  const Tree tree = build(scene, Builder::sah);
  for (const Ray& ray : random_rays(500, 27)) {
    const Hit plain = trace(scene, tree, ray);
    for (const float scale : {0x1p-40f, 0x1p-100f, 0x1p40f, 0x1p100f}) {
      const Hit scaled = trace(scene, tree, {ray.origin, scale * ray.direction});
      ASSERT_EQ(scaled.object, plain.object) << scale;
      if (plain) {
        ASSERT_DOUBLE_EQ(scaled.t * scale, plain.t) << scale;
      }
    }
  }
}

TEST(Traverse, WhatIsNoRayHitsNothingAndVisitsNothing) {
  const Scene scene = test::random_scene(100, 28);
  const Tree tree = build(scene, Builder::sah);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  std::vector<Ray> rays{{Vec3(0.0f), Vec3(0.0f)}, {Vec3(0.0f), {1, 0, 0}, 2.0f, 1.0f}};
  for (const float bad : {nan, inf, -inf}) {
    rays.push_back({{bad, 0, 0}, {1, 0, 0}});
    rays.push_back({{0, 0, 0}, {0, bad, 0}});
  }
  rays.push_back({{0, 0, 0}, {1, 0, 0}, nan, 1.0f});
  rays.push_back({{0, 0, 0}, {1, 0, 0}, 0.0f, nan});
  for (const Traversal traversal : traversals) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RayCost cost;
      CountObserver count(cost);
      EXPECT_FALSE(closest_hit({scene, tree}, rays[i], {.traversal = traversal}, count)) << i;
      EXPECT_EQ(cost, RayCost{}) << "ray " << i;
    }
  }
}

TEST(Traverse, AnyHitIsThereExactlyWhenTheClosestIs) {
  const Scene scene = test::random_scene(300, 29);
  for (const Builder builder : builders) {
    const Tree tree = build(scene, builder);
    for (Ray ray : random_rays(3000, 30)) {
      ray.t_max = 0.5f;
      ASSERT_EQ(occluded(scene, tree, ray), static_cast<bool>(trace(scene, tree, ray)));
    }
  }
}

TEST(Traverse, EqualHitsInCellsThatOverlapByRoundingGoToTheLowerObject) {
  // Leaves the corner of four squares within 2^-73 of a row of planes.
  const Scene scene = test::cube_grid(5, {0.1f, 0.2f, 0.3f});
  const Vec3 corner{0x1.19999ap+0f, 0x1.99999ap-2f, 0x1.cccccep-1f};
  const std::vector<Ray> rays{{corner, {-1.0f, 0x1.679524p-73f, -1.0f}}};
  for (const int leaf_size : {1, 4, 16}) {
    expect_brute_force(scene, build(scene, Builder::sah, leaf_size), rays);
    BuildParams params{.leaf_size = leaf_size};
    expect_brute_force(scene, *build_scene_tree(scene, params), rays);
  }
}

TEST(Traverse, HitsBehindTheOriginAreFoundWhereTheIntervalAllows) {
  const Scene scene = test::random_scene(300, 36);
  const Tree tree = build(scene, Builder::sah);
  std::vector<Ray> rays = random_rays(2000, 37);
  for (Ray& ray : rays) ray.t_min = -2.0f;
  expect_brute_force(scene, tree, rays);
}

TEST(Traverse, HitsOutsideTheIntervalDoNotCount) {
  const Scene scene = test::random_scene(300, 31);
  const Tree tree = build(scene, Builder::sah);
  Random random(32);
  for (Ray ray : random_rays(2000, 33)) {
    ray.t_min = random.between(0.0f, 1.0f);
    ray.t_max = ray.t_min + random.between(0.0f, 1.0f);
    const Hit expected = test::brute_force(scene, ray), found = trace(scene, tree, ray);
    ASSERT_EQ(found.object, expected.object);
    if (found) {
      ASSERT_TRUE(found.t > ray.t_min && found.t < ray.t_max);
    }
  }
}

TEST(Traverse, NaiveTestsEveryObjectAgainstEveryRay) {
  const Scene scene = test::random_scene(50, 34);
  const Tree tree = build(scene, Builder::naive);
  RayCost cost;
  CountObserver count(cost);
  const auto rays = random_rays(100, 35);
  for (const Ray& ray : rays) closest_hit({scene, tree}, ray, {}, count);
  EXPECT_EQ(cost.tests, 100u * 50u);
  EXPECT_EQ(cost.leaves, 100u);
  EXPECT_EQ(cost.inner, 0u);
}

TEST(Traverse, LogHoldsWhatTheCountsCount) {
  const Scene scene = test::random_scene(300, 36);
  const Tree tree = build(scene, Builder::sah);
  for (const Traversal traversal : traversals) {
    for (const Ray& ray : random_rays(300, 37)) {
      RayCost cost;
      CountObserver count(cost);
      RayLog log;
      LogObserver logger(log);
      const Hit counted = closest_hit({scene, tree}, ray, {.traversal = traversal}, count);
      const Hit logged = closest_hit({scene, tree}, ray, {.traversal = traversal}, logger);
      ASSERT_EQ(counted.object, logged.object);
      ASSERT_EQ(log.steps.size(), cost.inner + cost.leaves);
      ASSERT_EQ(log.tests.size(), cost.tests);
      if (counted) {
        ASSERT_EQ(log.steps.back().node, counted.leaf);
      }
    }
  }
}

}  // namespace
}  // namespace bspview
