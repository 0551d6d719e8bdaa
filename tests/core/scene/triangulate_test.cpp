#include "core/scene/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/scene/spd.h"
#include "core/shape/triangle.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using Polygon = std::vector<Vec3>;

Vec3d area_vector(Vec3 a, Vec3 b, Vec3 c) {
  return 0.5 * triangle_normal(a, b, c);
}

Vec3d area_vector(const Polygon& polygon) {
  Vec3d sum(0.0);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += area_vector(polygon[0], polygon[i - 1], polygon[i]);
  }
  return sum;
}

/// The triangles fill the polygon: none is turned over, and areas add up.
void expect_filled(const Polygon& polygon) {
  const Vec3d whole = area_vector(polygon);
  double sum = 0.0;
  for (const auto& [a, b, c] : triangulate_polygon(polygon)) {
    const Vec3d part = area_vector(polygon[a], polygon[b], polygon[c]);
    EXPECT_GT(glm::dot(part, whole), 0.0);
    sum += glm::length(part);
  }
  EXPECT_NEAR(sum, glm::length(whole), 1e-6 * glm::length(whole));
}

using Key = std::tuple<float, float, float>;
using Edge = std::pair<Key, Key>;

/// How often each edge is passed, in its direction.
std::map<Edge, int> edges_of(const Scene& mesh) {
  const auto key = [](Vec3 p) { return Key(p.x, p.y, p.z); };
  std::map<Edge, int> edges;
  for (const Face& face : mesh.faces) {
    const auto corners = vertices_of(mesh, face);
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{key(corners[i]), key(corners[(i + 1) % 3])}];
    }
  }
  return edges;
}

/// Edges without a neighbour that passes them the other way.
int open_edges(const Scene& mesh) {
  const std::map<Edge, int> edges = edges_of(mesh);
  int open = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    EXPECT_EQ(count, 1);
    open += back == edges.end() || back->second != 1;
  }
  return open;
}

double volume(const Scene& mesh) {
  double sum = 0.0;
  for (const Face& face : mesh.faces) {
    const auto corners = vertices_of(mesh, face);
    sum += glm::dot(Vec3d(corners[0]), area_vector(corners[0], corners[1], corners[2])) / 3.0;
  }
  return sum;
}

/// A star with `points` points, in the plane through three axes' unit points.
Polygon star(int points, double inner) {
  Polygon polygon;
  const Vec3d u = glm::normalize(Vec3d(1.0, -1.0, 0.0));
  const Vec3d v = glm::normalize(Vec3d(1.0, 1.0, -2.0));
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = 3.14159265358979 * i / points, r = i % 2 == 0 ? 1.0 : inner;
    polygon.push_back(Vec3(r * std::cos(angle) * u + r * std::sin(angle) * v));
  }
  return polygon;
}

TEST(Triangulate, AConvexPolygonIsFilledByTwoTrianglesLessThanCorners) {
  const Polygon hexagon = star(3, 1.0);
  EXPECT_EQ(triangulate_polygon(hexagon).size(), 4u);
  expect_filled(hexagon);
}

TEST(Triangulate, ConcavePolygonsAreFilledInBothSenses) {
  for (const double inner : {0.05, 0.3, 0.7}) {
    Polygon polygon = star(7, inner);
    EXPECT_EQ(triangulate_polygon(polygon).size(), 12u);
    expect_filled(polygon);
    std::ranges::reverse(polygon);
    expect_filled(polygon);
  }
}

TEST(Triangulate, RandomStarsAreFilled) {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    Polygon polygon;
    const int corners = 3 + trial % 20;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283185307 * i / corners, r = 0.1 + std::abs(random.point(1.0f).x);
      polygon.push_back(Vec3(Vec3d(r * std::cos(angle), 2.0, r * std::sin(angle))));
    }
    expect_filled(polygon);
  }
}

TEST(Triangulate, NoEdgePassesThroughAVertex) {
  // A square with three more vertices on every side: neighbours may have theirs there.
  Polygon polygon;
  const Vec3 corners[]{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}};
  for (int side = 0; side < 4; ++side) {
    const Vec3 from = corners[side], to = corners[(side + 1) % 4];
    for (int i = 0; i < 4; ++i)
      polygon.push_back(from + 0.25f * static_cast<float>(i) * (to - from));
  }
  expect_filled(polygon);
  const auto triangles = triangulate_polygon(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  for (const auto& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = polygon[triangle[i]], b = polygon[triangle[(i + 1) % 3]];
      for (const Vec3 p : polygon) {
        if (p == a || p == b || area_vector(a, b, p) != Vec3d(0.0)) continue;
        EXPECT_GT(glm::dot(p - a, p - b), 0.0f);
      }
    }
  }
}

TEST(Triangulate, NothingIsLeftOfAPolygonWithoutArea) {
  EXPECT_TRUE(triangulate_polygon(Polygon(5, Vec3(1.0f))).empty());
  EXPECT_TRUE(triangulate_polygon(Polygon{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}).empty());
}

TEST(Triangulate, WhatCrossesItselfEndsWithFiniteTriangles) {
  const Polygon bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}};
  for (const auto& [a, b, c] : triangulate_polygon(bow)) {
    EXPECT_NE(area_vector(bow[a], bow[b], bow[c]), Vec3d(0.0));
  }
}

TEST(Triangulate, ASphereIsAClosedMeshOfVerticesOnIt) {
  for (const int segments : {4, 8, 20}) {
    Scene scene;
    add_sphere(scene, add_material(scene, {}), {{1.0f, 2.0f, 3.0f}, 0.5f});
    const Scene mesh = triangulate(scene, segments);
    EXPECT_EQ(mesh.objects.size(), static_cast<std::size_t>(segments * (segments - 2)));
    EXPECT_EQ(mesh.objects.size(), count_triangles(scene, segments));
    EXPECT_EQ(open_edges(mesh), 0);
    for (const Vec3 p : mesh.vertices) {
      EXPECT_NEAR(glm::length(p - Vec3(1.0f, 2.0f, 3.0f)), 0.5, 1e-6);
    }
    const double ball = 4.0 / 3.0 * 3.14159265 * 0.125;
    EXPECT_GT(volume(mesh), 0.3 * ball);
    EXPECT_LT(volume(mesh), ball);
  }
}

TEST(Triangulate, AnInsideOutSphereHasItsTrianglesTurned) {
  Scene scene;
  add_sphere(scene, add_material(scene, {}), {{0.0f, 0.0f, 0.0f}, -1.0f});
  EXPECT_LT(volume(triangulate(scene, 8)), 0.0);
}

TEST(Triangulate, ACylinderIsOpenAtItsEndsOnly) {
  Scene scene;
  add_cone(scene, add_material(scene, {}), {{0, 0, 0}, 1.0f, {1, 2, 3}, 0.5f});
  const Scene mesh = triangulate(scene, 6);
  EXPECT_EQ(mesh.objects.size(), 12u);
  EXPECT_EQ(open_edges(mesh), 12);
  for (const Face& face : mesh.faces) {
    const auto corners = vertices_of(mesh, face);
    const Vec3d middle = Vec3d(corners[0] + corners[1] + corners[2]) / 3.0;
    const Vec3d normal = area_vector(corners[0], corners[1], corners[2]);
    EXPECT_GT(glm::dot(normal, cone_normal(scene.cones[0], middle)), 0.0);
  }
}

TEST(Triangulate, TheTipOfAConeNeedsOneTriangleASegment) {
  Scene scene;
  add_cone(scene, add_material(scene, {}), {{0, 0, 0}, 1.0f, {0, 0, 2}, 0.0f});
  const Scene mesh = triangulate(scene, 8);
  EXPECT_EQ(mesh.objects.size(), 8u);
  EXPECT_EQ(open_edges(mesh), 8);
}

TEST(Triangulate, OnlyTrianglesAreLeftOfASceneAndTheRestStays) {
  const Scene scene = test::random_scene(100, 3);
  const Scene mesh = triangulate(scene, 4);
  EXPECT_EQ(mesh.camera, scene.camera);
  EXPECT_EQ(mesh.lights, scene.lights);
  EXPECT_EQ(mesh.materials, scene.materials);
  EXPECT_GT(mesh.objects.size(), scene.objects.size());
  EXPECT_LE(mesh.objects.size(), count_triangles(scene, 4));
  for (std::uint32_t id = 0; id < mesh.objects.size(); ++id) {
    EXPECT_EQ(mesh.objects[id].kind, ObjectKind::triangle);
    EXPECT_FALSE(is_degenerate(mesh, id));
  }
  EXPECT_TRUE(mesh.spheres.empty() && mesh.cones.empty() && mesh.normals.empty());
}

TEST(Triangulate, DegenerateObjectsGo) {
  Scene scene;
  const std::uint32_t material = add_material(scene, {});
  add_sphere(scene, material, {{0, 0, 0}, 0.0f});
  add_sphere(scene, material, {{NAN, 0, 0}, 1.0f});
  add_cone(scene, material, {{1, 1, 1}, 1.0f, {1, 1, 1}, 1.0f});
  add_face(scene, material, Polygon(4, Vec3(2.0f)));
  EXPECT_TRUE(triangulate(scene, 8).objects.empty());
}

TEST(Triangulate, TheGearsOfTheStandardSceneAreFilled) {
  const Scene scene = *make_spd("gears", 1);
  for (const Face& face : scene.faces) {
    const auto vertices = vertices_of(scene, face);
    if (face.vertex_count > 3) expect_filled({vertices.begin(), vertices.end()});
  }
  EXPECT_EQ(triangulate(scene, 8).objects.size(), count_triangles(scene, 8));
}

}  // namespace
}  // namespace bspview
