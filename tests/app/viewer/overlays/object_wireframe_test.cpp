#include "app/viewer/overlays/object_wireframe.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bspview {
namespace {

LineList wireframe(const Scene& scene) {
  LineList lines;
  add_wireframe(lines, scene, 0, {.color = 0xff112233u, .width = 2.0f});
  return lines;
}

TEST(ObjectWireframe, APolygonHasItsEdges) {
  Scene scene;
  const std::vector<Vec3> corners{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 1, 0}};
  add_face(scene, add_material(scene, {}), corners);
  const LineList lines = wireframe(scene);
  ASSERT_EQ(lines.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lines[i].from, corners[i]);
    EXPECT_EQ(lines[i].to, corners[(i + 1) % 4]);
    EXPECT_EQ(lines[i].color, 0xff112233u);
    EXPECT_EQ(lines[i].width, 2.0f);
  }
}

TEST(ObjectWireframe, ASpheresCirclesLieOnIt) {
  Scene scene;
  add_sphere(scene, add_material(scene, {}), {{1.0f, 2.0f, 3.0f}, -0.5f});
  const LineList lines = wireframe(scene);
  EXPECT_GE(lines.size(), 3u * 16u);
  for (const Line& line : lines) {
    EXPECT_NEAR(glm::length(line.from - Vec3(1.0f, 2.0f, 3.0f)), 0.5f, 1e-5f);
  }
}

TEST(ObjectWireframe, AConesRimsLieOnItWhateverItsDirection) {
  for (const Vec3 axis : {Vec3(0, 0, 3), Vec3(2, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 1)}) {
    Scene scene;
    const Vec3 base(1.0f, 0.0f, 2.0f);
    add_cone(scene, add_material(scene, {}), {base, 1.0f, base + axis, 0.25f});
    for (const Line& line : wireframe(scene)) {
      for (const Vec3 point : {line.from, line.to}) {
        const float along = glm::dot(point - base, axis) / glm::dot(axis, axis);
        const float radius = glm::length(point - base - along * axis);
        EXPECT_NEAR(radius, 1.0f - 0.75f * along, 1e-5f);
        EXPECT_TRUE(std::abs(along) < 1e-5f || std::abs(along - 1.0f) < 1e-5f);
      }
    }
  }
}

TEST(ObjectWireframe, WhatIsNoObjectHasNone) {
  Scene scene;
  EXPECT_TRUE(wireframe(scene).empty());
  add_sphere(scene, add_material(scene, {}), {{0.0f, 0.0f, 0.0f}, std::nanf("")});
  EXPECT_TRUE(wireframe(scene).empty());
}

}  // namespace
}  // namespace bspview
