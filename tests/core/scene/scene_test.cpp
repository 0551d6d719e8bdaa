#include "core/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bspview {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

const Vec3 quad[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

bool contains(const Aabb& box, Vec3d p) {
  return box.lo.x <= p.x && p.x <= box.hi.x && box.lo.y <= p.y && p.y <= box.hi.y &&
         box.lo.z <= p.z && p.z <= box.hi.z;
}

Vec3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(Vec3d(normal(random), normal(random), normal(random)));
}

Vec3 random_point(std::mt19937& random, float size) {
  std::uniform_real_distribution<float> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

TEST(Scene, EqualMaterialsAreKeptOnce) {
  Scene scene;
  Material red, blue;
  red.color = {1.0f, 0.0f, 0.0f};
  blue.color = {0.0f, 0.0f, 1.0f};
  EXPECT_EQ(add_material(scene, red), 0u);
  EXPECT_EQ(add_material(scene, blue), 1u);
  EXPECT_EQ(add_material(scene, red), 0u);
  EXPECT_EQ(scene.materials.size(), 2u);
}

TEST(Scene, CountsEveryKindAndAPatchAsPatch) {
  Scene scene;
  add_face(scene, 0, std::span(quad).first(3));
  add_face(scene, 0, quad);
  add_face(scene, 0, quad, quad);
  add_face(scene, 0, std::span(quad).first(3), std::span(quad).first(3));
  add_sphere(scene, 0, {});
  add_cone(scene, 0, {});
  EXPECT_EQ(count_objects(scene), (ObjectCounts{6, 1, 1, 2, 1, 1}));
  EXPECT_EQ(scene.objects[0].kind, ObjectKind::triangle);
  EXPECT_EQ(scene.objects[1].kind, ObjectKind::polygon);
  EXPECT_EQ(scene.faces[3].first_normal, 4u);
}

TEST(ObjectBounds, OfAFaceAreItsVerticesExactly) {
  Scene scene;
  add_face(scene, 0, quad);
  EXPECT_EQ(object_bounds(scene, 0), (Aabb{Vec3(0), Vec3(1, 1, 0)}));
}

TEST(ObjectBounds, HoldEveryPointOfASphere) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    Scene scene;
    const float radius = std::ldexp(trial % 2 ? 1.3f : -1.3f, trial % 40 - 20);
    add_sphere(scene, 0, {random_point(random, 100.0f), radius});
    const Aabb box = object_bounds(scene, 0);
    const Vec3d centre(scene.spheres[0].centre);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d pole(0.0);
      pole[axis] = radius;
      EXPECT_TRUE(contains(box, centre + pole) && contains(box, centre - pole));
    }
  }
}

TEST(ObjectBounds, HoldTheEndCirclesOfAConeAndNoMore) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    Scene scene;
    const Cone cone{random_point(random, 10.0f), 2.5f, random_point(random, 10.0f), 0.5f};
    add_cone(scene, 0, cone);
    const Aabb box = object_bounds(scene, 0);
    const Vec3d axis = glm::normalize(Vec3d(cone.apex) - Vec3d(cone.base));
    Aabb touched;
    for (int i = 0; i < 200; ++i) {
      const Vec3d across = glm::normalize(glm::cross(axis, random_direction(random)));
      EXPECT_TRUE(contains(box, Vec3d(cone.base) + across * 2.5 * (1.0 - 1e-12)));
      EXPECT_TRUE(contains(box, Vec3d(cone.apex) + across * 0.5 * (1.0 - 1e-12)));
      touched.grow(Vec3(Vec3d(cone.base) + across * 2.5));
      touched.grow(Vec3(Vec3d(cone.apex) + across * 0.5));
    }
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(box.extent()[i], touched.extent()[i], 0.2f);
  }
}

TEST(ObjectBounds, OfAnAxisAlignedCylinderAreTightAlongItsAxis) {
  Scene scene;
  add_cone(scene, 0, {Vec3(1, 2, 3), -2.0f, Vec3(1, 2, 7), -2.0f});
  const Aabb box = object_bounds(scene, 0);
  EXPECT_EQ(box.lo.z, 3.0f);
  EXPECT_EQ(box.hi.z, 7.0f);
  EXPECT_NEAR(box.lo.x, -1.0f, 1e-6f);
  EXPECT_NEAR(box.hi.y, 4.0f, 1e-6f);
}

TEST(ObjectBounds, AreEmptyForNumbersThatCannotBeTraced) {
  for (const float bad : {nan, infinity, -infinity, 2.0f * max_coordinate}) {
    Scene scene;
    Vec3 vertices[] = {{0, 0, 0}, {1, 0, 0}, {0, bad, 0}};
    add_face(scene, 0, vertices);
    add_sphere(scene, 0, {Vec3(0, bad, 0), 1.0f});
    add_sphere(scene, 0, {Vec3(0), bad});
    add_cone(scene, 0, {Vec3(0), 1.0f, Vec3(0, 0, bad), 1.0f});
    add_cone(scene, 0, {Vec3(bad), 1.0f, Vec3(0), 1.0f});
    add_cone(scene, 0, {Vec3(0), bad, Vec3(0, 0, 1), 1.0f});
    for (const Aabb& box : object_bounds(scene)) EXPECT_EQ(box, Aabb{});
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) EXPECT_TRUE(is_degenerate(scene, i));
    EXPECT_TRUE(scene_bounds(scene).empty());
  }
}

TEST(SceneBounds, AreTheUnionOfTheObjectBoxes) {
  Scene scene;
  EXPECT_TRUE(scene_bounds(scene).empty());
  add_face(scene, 0, quad);
  add_sphere(scene, 0, {Vec3(4, 0, 0), 1.0f});
  EXPECT_EQ(scene_bounds(scene), (Aabb{Vec3(0, -1, -1), Vec3(5, 1, 1)}));
}

TEST(IsDegenerate, ForObjectsWithoutExtent) {
  Scene scene;
  const Vec3 needle[] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  const Vec3 point[] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  add_face(scene, 0, needle);
  add_face(scene, 0, point);
  add_sphere(scene, 0, {Vec3(1), 0.0f});
  add_cone(scene, 0, {Vec3(1), 1.0f, Vec3(1), 2.0f});
  add_cone(scene, 0, {Vec3(1), 0.0f, Vec3(2), 0.0f});
  add_cone(scene, 0, {Vec3(1), 1.0f, Vec3(2), -1.0f});
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    EXPECT_TRUE(is_degenerate(scene, i)) << "object " << i;
}

TEST(IsDegenerate, NotForOrdinaryObjectsOfAnySize) {
  for (const float size : {1e-15f, 1e-8f, 1.0f, 1e8f, 1e15f}) {
    Scene scene;
    const Vec3 corner[] = {Vec3(0), size * Vec3(1, 0, 0), size * Vec3(0, 1, 0)};
    add_face(scene, 0, corner);
    add_sphere(scene, 0, {Vec3(size), size});
    add_sphere(scene, 0, {Vec3(size), -size});
    add_cone(scene, 0, {Vec3(0), size, Vec3(size), 0.0f});
    add_cone(scene, 0, {Vec3(0), -size, Vec3(size), -size});
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
      EXPECT_FALSE(is_degenerate(scene, i)) << "object " << i << ", size " << size;
  }
}

}  // namespace
}  // namespace bspview
