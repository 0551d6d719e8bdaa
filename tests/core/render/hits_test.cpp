#include "core/render/hits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/render/accelerator.h"
#include "core/render/scene_tree.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using test::Random;

class HitsTest : public testing::TestWithParam<std::int64_t> {
  test::OneInstructionSet set_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(EverySet, HitsTest, testing::ValuesIn(test::instruction_sets()),
                         [](const auto& set) { return hwy::TargetName(set.param); });

/// Every hit and every occlusion as the binary tree finds it.
void expect_answers_of_binary_tree(const Scene& scene, const std::vector<Ray>& rays,
                                   SideRule rule) {
  const auto tree = build_scene_tree(scene, {});
  const FastWorld fast({scene, *tree});
  const World& world = fast.world();
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint32_t> found(rays.size());
  closest_hits(world, rays, rule, hits);
  any_hits(world, rays, rule, found);
  NoObserver none;
  int hit_count = 0;
  const TraceRules rules{.sides = rule, .shadow_sides = rule};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit single = closest_hit(world, rays[i], rules, none);
    const double t_found =
        found[i] == no_index ? no_hit : hit_object(scene, found[i], RayQuery(rays[i]), rule);
    ASSERT_EQ(t_found != no_hit, found[i] != no_index) << "ray " << i;
    ASSERT_EQ(hits[i].object, single.object) << "ray " << i;
    ASSERT_EQ(hits[i].t, single.t) << "ray " << i;
    const bool is_blocked = any_hit(world, rays[i], rules, none) != no_index;
    ASSERT_EQ(found[i] != no_index, is_blocked) << "ray " << i;
    const Hit alone = fast_closest_hit(world, rays[i], rule);
    ASSERT_EQ(alone.object, single.object) << "ray " << i;
    ASSERT_EQ(alone.t, single.t) << "ray " << i;
    ASSERT_EQ(fast_any_hit(world, rays[i], rule) != no_index, is_blocked) << "ray " << i;
    hit_count += single ? 1 : 0;
  }
  EXPECT_GT(hit_count, static_cast<int>(rays.size()) / 20);
}

/// From one point through neighbouring points: what packets are for.
std::vector<Ray> bundle(int count, Random& random) {
  std::vector<Ray> rays;
  Vec3 eye(0.0f), target(0.0f);
  for (int i = 0; i < count; ++i) {
    if (i % 40 == 0) {  // some packets, and groups of them, are mixed
      eye = 4.0f * random.direction();
      target = random.point(0.5f);
    }
    rays.push_back({eye, target + random.point(0.05f) - eye});
  }
  return rays;
}

TEST_P(HitsTest, BundlesFindWhatTheBinaryTreeFinds) {
  Random random(1);
  for (const SideRule rule :
       {SideRule::two_sided, SideRule::opaque_one_sided, SideRule::one_sided}) {
    expect_answers_of_binary_tree(test::random_scene(300, 11), bundle(3000, random), rule);
    expect_answers_of_binary_tree(test::random_triangles(500, 12), bundle(3000, random), rule);
  }
}

/// Rays of a bundle, and others that leave what they hit.
std::vector<Ray> bundle_and_bounces(const Scene& scene, Vec3 centre, Random& random) {
  std::vector<Ray> rays = bundle(2000, random);
  for (Ray& ray : rays) ray.origin += centre;
  const auto tree = build_scene_tree(scene, {});
  NoObserver none;
  for (int i = 0; i < 2000; ++i) {
    const Ray& ray = rays[static_cast<std::size_t>(i)];
    const Hit hit = closest_hit({scene, *tree}, ray, {}, none);
    if (hit) rays.push_back({ray.at(static_cast<float>(hit.t)), random.direction(), 1e-4f});
  }
  return rays;
}

TEST_P(HitsTest, ScenesOfManyBranchesAreWhatTheBinaryTreeFinds) {
  Random random(7);
  for (const Vec3 centre : {Vec3(0.0f), Vec3(500.0f, -20.0f, 3.0f)}) {
    const Scene scene = test::random_scene(3000, 21, centre);
    expect_answers_of_binary_tree(scene, bundle_and_bounces(scene, centre, random),
                                  SideRule::two_sided);
  }
  const Scene triangles = test::random_triangles(5000, 22);
  expect_answers_of_binary_tree(triangles, bundle_and_bounces(triangles, Vec3(0.0f), random),
                                SideRule::two_sided);
}

/// Rays from far away that pass the border of what one of them hits by as little as floats can
/// tell.
std::vector<Ray> grazing_bundle(const Scene& scene, const Tree& tree, Random& random) {
  const Vec3 eye = 40.0f * random.direction();
  const Vec3 from = random.point(0.8f), to = from + random.point(0.3f);
  const auto ray = [&](double s) {
    return Ray{eye, Vec3(glm::mix(Vec3d(from), Vec3d(to), s)) - eye};
  };
  NoObserver none;
  const auto object = [&](double s) { return closest_hit({scene, tree}, ray(s), {}, none).object; };
  const std::uint32_t hit = object(0.0);
  double on = 0.0, off = 1.0;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (on + off);
    (object(middle) == hit ? on : off) = middle;
  }
  std::vector<Ray> rays;
  for (int i = -8; i < 8; ++i) rays.push_back(ray(on + i * 1e-6));
  return rays;
}

TEST_P(HitsTest, BundlesAlongBordersFindWhatTheBinaryTreeFinds) {
  Random random(4);
  for (const Scene& scene : {test::random_scene(150, 21), test::random_triangles(200, 22)}) {
    const auto tree = build_scene_tree(scene, {});
    std::vector<Ray> rays;
    for (int i = 0; i < 200; ++i) {
      const std::vector<Ray> bundle = grazing_bundle(scene, *tree, random);
      rays.insert(rays.end(), bundle.begin(), bundle.end());
    }
    expect_answers_of_binary_tree(scene, rays, SideRule::two_sided);
  }
}

TEST_P(HitsTest, RaysAnyhowFindWhatTheBinaryTreeFinds) {
  Random random(2);
  std::vector<Ray> rays;
  for (int i = 0; i < 3001; ++i) {
    Ray ray{random.point(2.0f), random.direction()};
    if (random.below(4) == 0) ray.t_max = random.between(0.0f, 2.0f);
    if (random.below(4) == 0) ray.t_min = random.between(-1.0f, 1.0f);
    if (random.below(8) == 0) ray.direction *= 1e30f;
    if (random.below(8) == 0) ray.direction *= 1e-30f;
    rays.push_back(ray);
  }
  expect_answers_of_binary_tree(test::random_scene(300, 13), rays, SideRule::two_sided);
}

TEST_P(HitsTest, RaysInPlanesAndAlongAxesFindWhatTheBinaryTreeFinds) {
  Random random(3);
  std::vector<Ray> rays;
  const auto step = [&] { return 0.25f * static_cast<float>(random.below(17) - 8); };
  for (int i = 0; i < 4000; ++i) {
    const Vec3 origin(step(), step(), step());
    Vec3 direction(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const float sign = random.below(2) == 0 ? -1.0f : 1.0f;
      direction[axis] = sign * static_cast<float>(random.below(2));
    }
    if (direction == Vec3(0.0f)) direction.x = 1.0f;
    for (int k = 0; k < 4; ++k) rays.push_back({origin, direction});
  }
  expect_answers_of_binary_tree(test::cube_grid(8, Vec3(0.0f)), rays, SideRule::two_sided);
}

TEST_P(HitsTest, RaysThatEndJustBehindWhatTheyHitFindIt) {
  Random random(7);
  const auto step = [&] { return 0.25f * static_cast<float>(random.below(33) - 16); };
  const Scene scene = test::cube_grid(8, Vec3(0.0f));
  const auto tree = build_scene_tree(scene, {});
  NoObserver none;
  std::vector<Ray> rays;
  while (rays.size() < 8000) {
    Ray ray{{step(), step(), step()}, {step(), step(), step()}};
    const Hit hit = closest_hit({scene, *tree}, ray, {}, none);
    if (!hit) continue;
    const float t = static_cast<float>(hit.t);
    ray.t_max = t > hit.t ? t : std::nextafter(t, 2.0f * t);
    rays.push_back(ray);
  }
  expect_answers_of_binary_tree(scene, rays, SideRule::two_sided);
}

TEST_P(HitsTest, RaysNearlyAlongPlanesFindWhatTheBinaryTreeFinds) {
  Random random(8);
  const auto step = [&] { return 0.25f * static_cast<float>(random.below(17) - 8); };
  std::vector<Ray> rays;
  for (int i = 0; i < 4000; ++i) {
    Ray ray{{step(), step(), step()}, {step(), step(), step()}};
    const int axis = random.below(3), next = (axis + 1) % 3;
    if (ray.direction[next] == 0.0f) ray.direction[next] = 1.0f;
    ray.direction[axis] = random.below(2) == 0 ? 1e-40f : -1e-40f;  // less than any normal number
    rays.push_back(ray);
    ray.origin[axis] = -ray.direction[axis];
    rays.push_back(ray);
  }
  expect_answers_of_binary_tree(test::cube_grid(8, Vec3(0.0f)), rays, SideRule::two_sided);
}

TEST_P(HitsTest, RaysAlongAxesThroughCornersOfEveryShapeFindWhatTheBinaryTreeFinds) {
  Random random(5);
  const Scene scene = test::random_scene(200, 15);
  std::vector<Ray> rays;
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    const Aabb box = object_bounds(scene, id);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 origin = random.below(2) == 0 ? box.lo : box.hi, direction(0.0f);
      if (random.below(2) == 0) origin[(axis + 1) % 3] = box.centre()[(axis + 1) % 3];
      direction[axis] = random.below(2) == 0 ? 1.0f : -1.0f;
      origin[axis] -= 3.0f * direction[axis];
      rays.push_back({origin, direction});
    }
  }
  expect_answers_of_binary_tree(scene, rays, SideRule::two_sided);
}

TEST_P(HitsTest, ARayBesideARoundShapeByLessThanRoundingFindsWhatTheBinaryTreeFinds) {
  Scene scene;
  scene.materials.resize(1);
  add_sphere(scene, 0, {Vec3(0.0f), 0.5f});
  add_sphere(scene, 0, {Vec3(8.0f), 0.5f});
  std::vector<Ray> rays;
  for (int i = 0; i < 32; ++i) {  // so many along the lowest point of the first
    rays.push_back({{-12.0f, 12.0f, -0.5f}, {1.0f, -1.0f, i % 2 == 0 ? -0x1p-72f : -0x1p-110f}});
  }
  const auto tree = build_scene_tree(scene, {});
  NoObserver none;
  ASSERT_EQ(closest_hit({scene, *tree}, rays[0], {}, none).object, 0u);
  expect_answers_of_binary_tree(scene, rays, SideRule::two_sided);
}

/// Balls, cylinders, cones with and without an apex, each seen from outside or from inside, and
/// some without a radius.
Scene round_shapes(int count, Random& random) {
  Scene scene;
  scene.materials.resize(1);
  const auto radius = [&] { return random.below(8) == 0 ? 0.0f : random.between(0.1f, 0.4f); };
  for (int i = 0; i < count; ++i) {
    const float sign = random.below(3) == 0 ? -1.0f : 1.0f;
    const Vec3 base = random.point(1.0f);
    const float base_radius = sign * radius();
    const float apex_radius = random.below(2) == 0 ? base_radius : sign * radius();
    add_sphere(scene, 0, {random.point(1.0f), sign * radius()});
    add_cone(scene, 0, {base, base_radius, base + 0.6f * random.direction(), apex_radius});
  }
  return scene;
}

TEST_P(HitsTest, RoundShapesOfEveryFormFindWhatTheBinaryTreeFinds) {
  Random random(9);
  for (const SideRule rule : {SideRule::two_sided, SideRule::one_sided}) {
    std::vector<Ray> rays = bundle(4000, random);
    for (std::size_t first = 0; first < rays.size(); first += 40) {
      const float start = random.between(0.0f, 1.2f), end = random.between(0.5f, 2.0f);
      for (Ray& ray : std::span(rays).subspan(first, 40)) {
        if (first % 80 == 0) ray.origin += start * ray.direction;
        if (first % 120 == 0) ray.t_max = end;
      }
    }
    expect_answers_of_binary_tree(round_shapes(20, random), rays, rule);
  }
}

TEST_P(HitsTest, RaysAlongTheAxesOfCylindersFindWhatTheBinaryTreeFinds) {
  Random random(10);
  Scene scene;
  scene.materials.resize(1);
  for (const Vec3 base : {Vec3(0.0f), Vec3(4.0f, 0.0f, 0.0f)}) {
    add_cone(scene, 0, {base, 1.0f, base + Vec3(1.0f), 1.0f});
    add_sphere(scene, 0, {base + Vec3(3.0f), 0.5f});
  }
  std::vector<Ray> rays;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 target(static_cast<float>(4 * (i / 40 % 2)), 0.0f, 0.0f);
    rays.push_back({target + random.point(0.5f) - Vec3(3.0f), Vec3(1.0f)});
  }
  expect_answers_of_binary_tree(scene, rays, SideRule::two_sided);
}

/// Beside the axis by many radii, and yet by less than the rounding of a discriminant.
TEST_P(HitsTest, RaysBesideAHairFindWhatTheBinaryTreeFinds) {
  Scene scene;
  scene.materials.resize(1);
  add_cone(scene, 0, {Vec3(0.0f), 1e-10f, Vec3(1.0f), 1e-10f});
  add_sphere(scene, 0, {Vec3(0.0f, 0.0f, -1.0f), 0.5f});
  std::vector<Ray> rays;
  for (int i = 0; i < 64; ++i) {
    const float x = 0x1p-8f + static_cast<float>(i) * 0x1p-31f;
    rays.push_back({{x, 0x1p-8f, 1.0f}, {1e-25f, 1e-25f, -1.0f}});
  }
  expect_answers_of_binary_tree(scene, rays, SideRule::two_sided);
}

TEST_P(HitsTest, WithoutAnAcceleratorRaysGoThroughTheBinaryTree) {
  Random random(6);
  const Scene scene = test::random_scene(100, 16);
  const auto tree = build_scene_tree(scene, {.builder = Builder::naive});
  const FastWorld fast({scene, *tree});
  EXPECT_EQ(fast.world().accelerator, nullptr);
  const std::vector<Ray> rays = bundle(200, random);
  std::vector<Hit> hits(rays.size());
  closest_hits(fast.world(), rays, SideRule::two_sided, hits);
  NoObserver none;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(hits[i].object, closest_hit(fast.world(), rays[i], {}, none).object);
  }
}

TEST_P(HitsTest, WhatIsNoRayHitsNothingAndDisturbsNobody) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  Random random(4);
  std::vector<Ray> rays = bundle(2000, random);
  for (std::size_t i = 0; i < rays.size(); i += 5) {
    const int axis = random.below(3);
    switch (random.below(5)) {
      case 0:
        rays[i].direction = Vec3(0.0f);
        break;
      case 1:
        rays[i].direction[axis] = nan;
        break;
      case 2:
        rays[i].origin[axis] = nan;
        break;
      case 3:
        rays[i].origin[axis] = inf;
        break;
      default:
        rays[i].t_max = -1.0f;
    }
  }
  expect_answers_of_binary_tree(test::random_scene(300, 14), rays, SideRule::two_sided);
}

}  // namespace
}  // namespace bspview
