#include "core/shape/polygon.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/shape/triangle.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;

/// An L of six corners in the plane z = 0: the square [0, 2]^2 without its upper right quarter.
const std::vector<Vec3> ell{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

double hit(const RayQuery& ray, std::span<const Vec3> vertices, Sides sides = Sides::both) {
  return hit_polygon(ray, vertices, polygon_plane(vertices), sides);
}

double hit_at(float x, float y, std::span<const Vec3> vertices) {
  return hit(RayQuery({{x, y, 1}, {0, 0, -1}}), vertices);
}

TEST(Polygon, ConcaveCornerIsLeftOut) {
  EXPECT_EQ(hit_at(0.5f, 0.5f, ell), 1.0);
  EXPECT_EQ(hit_at(1.5f, 0.5f, ell), 1.0);
  EXPECT_EQ(hit_at(0.5f, 1.5f, ell), 1.0);
  EXPECT_EQ(hit_at(1.5f, 1.5f, ell), no_hit);
  EXPECT_EQ(hit_at(-0.5f, 0.5f, ell), no_hit);
}

TEST(Polygon, EveryPointOfASharedEdgeBelongsToExactlyOne) {
  const std::vector<Vec3> left{{0, 0, 0}, {1, 0.25f, 0}, {0.75f, 1, 0}, {0, 1, 0}};
  const std::vector<Vec3> right{{1, 0.25f, 0}, {2, 0, 0}, {2, 1, 0}, {0.75f, 1, 0}};
  Random random(6);
  for (int trial = 0; trial < 100000; ++trial) {
    const float s = random.between(0.01f, 0.99f);
    const Vec3 target = left[1] + s * (left[2] - left[1]);
    const Vec3 origin = Vec3(1, 0.5f, 0) + 2.0f * random.direction();
    if (std::abs(origin.z) < 0.1f) continue;
    const RayQuery ray({origin, target - origin});
    const int hits = (hit(ray, left) != no_hit) + (hit(ray, right) != no_hit);
    ASSERT_EQ(hits, 1) << "trial " << trial;
  }
}

TEST(Polygon, KnownReachChangesTheSpeedAlone) {
  // Without a reach no rounding is bounded, and every test is decided exactly.
  Random random(8);
  int hits = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const Vec3 centre = random.point(trial % 2 == 0 ? 1.0f : 1000.0f);
    const Vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction()));
    std::vector<Vec3> corners;
    for (const Vec3& corner : ell) corners.push_back(centre + corner.x * u + corner.y * v);
    const Vec3 from = corners[static_cast<std::size_t>(random.below(6))];
    const Vec3 to = corners[static_cast<std::size_t>(random.below(6))];
    const float share = random.below(3) == 0 ? 0.0f : random.unit();
    const Vec3 origin = centre + random.between(0.001f, 100.0f) * random.direction();
    const Ray ray{origin, (from + share * (to - from)) - origin};
    float reach = 0.0f;
    for (const Vec3& corner : corners)
      reach = std::max(reach, largest_component(glm::abs(corner - origin)));
    const double exact = hit(RayQuery(ray), corners);
    ASSERT_EQ(hit(RayQuery(ray, reach), corners), exact) << "trial " << trial;
    hits += exact != no_hit;
  }
  EXPECT_GT(hits, 20000);
}

TEST(Polygon, OffItsPlaneItIsMetNoLaterThanItsBoxEndsAndNoSoonerThanItsPlane) {
  Random random(9);
  int moved = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const Vec3 centre = 200000.0f * random.direction();  // floats lie 1/64 apart
    const Vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction()));
    std::vector<Vec3> corners;
    for (const Vec3& corner : ell) corners.push_back(centre + corner.x * u + corner.y * v);
    const Ray ray{centre + 5.0f * random.direction(), random.direction()};
    const PolygonPlane plane = polygon_plane(corners);
    const double t = hit_polygon(RayQuery(ray, 16.0f), corners, plane, Sides::both);
    if (t == no_hit) continue;
    const Vec3d way(ray.direction);
    const double slope = glm::dot(plane.normal, way);
    const double at_plane = glm::dot(plane.normal, plane.point - Vec3d(ray.origin)) / slope;
    ASSERT_GE(t, at_plane - 1e-12 * std::abs(at_plane)) << "trial " << trial;
    ASSERT_LE(t, at_plane + 1.01 * plane.thickness / std::abs(slope)) << "trial " << trial;
    if (t <= at_plane * (1.0 + 1e-5)) continue;
    ++moved;
    Aabb box;
    for (const Vec3& corner : corners) box.grow(corner);
    for (int axis = 0; axis < 3; ++axis) {
      const double at = ray.origin[axis] + t * way[axis];
      const double beyond = way[axis] > 0.0 ? at - box.hi[axis] : box.lo[axis] - at;
      ASSERT_LE(beyond, 1e-6) << "trial " << trial;
    }
  }
  EXPECT_GT(moved, 300);
}

TEST(Polygon, FrontIsWhereVerticesRunCounterClockwise) {
  const RayQuery above({{0.5f, 0.5f, 1}, {0, 0, -1}}), below({{0.5f, 0.5f, -1}, {0, 0, 1}});
  EXPECT_EQ(hit(above, ell, Sides::front), 1.0);
  EXPECT_EQ(hit(below, ell, Sides::front), no_hit);
}

TEST(Polygon, ClippedBoxHoldsEveryPointInsideTheCell) {
  Random random(7);
  for (int trial = 0; trial < 20000; ++trial) {
    const std::array<Vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    const Vec3 lo = random.point(0.7f);
    const Aabb cell{lo, lo + Vec3(0.5f)};
    const Aabb part = clip_polygon(corners, cell);
    for (int k = 0; k < 20; ++k) {
      float u = random.unit(), v = random.unit();
      if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
      const Vec3d p = Vec3d(corners[0]) + double(u) * (Vec3d(corners[1]) - Vec3d(corners[0])) +
                      double(v) * (Vec3d(corners[2]) - Vec3d(corners[0]));
      const bool in_cell = glm::all(glm::greaterThanEqual(p, Vec3d(cell.lo))) &&
                           glm::all(glm::lessThanEqual(p, Vec3d(cell.hi)));
      if (!in_cell) continue;
      const bool in_part = glm::all(glm::greaterThanEqual(p, Vec3d(part.lo) - 1e-15)) &&
                           glm::all(glm::lessThanEqual(p, Vec3d(part.hi) + 1e-15));
      ASSERT_TRUE(in_part) << "trial " << trial;
    }
  }
}

TEST(Polygon, ClippingKeepsWhatTouchesAndDropsWhatPassesBy) {
  const std::array<Vec3, 3> corners{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  EXPECT_FALSE(clip_polygon(corners, {{0.5f, 0.5f, 0}, {1, 1, 1}}).empty());  // one corner touches
  EXPECT_TRUE(clip_polygon(corners, {{0.6f, 0.6f, -1}, {1, 1, 1}}).empty());
  EXPECT_FALSE(clip_polygon(corners, {{0, 0, 0}, {1, 1, 1}}).empty());  // lies in a side
  EXPECT_EQ(clip_polygon(corners, {{-1, -1, -1}, {2, 2, 2}}), (Aabb{{0, 0, 0}, {1, 1, 0}}));
}

TEST(Polygon, ManyCornersAreClippedLikeFew) {
  std::vector<Vec3> circle;
  for (int i = 0; i < 144; ++i) {
    const float angle = static_cast<float>(i) * 6.2831853f / 144.0f;
    circle.push_back({std::cos(angle), std::sin(angle), 0.5f});
  }
  const Aabb part = clip_polygon(circle, {{0, 0, 0}, {0.5f, 2, 1}});
  EXPECT_NEAR(part.lo.x, 0.0f, 1e-6f);
  EXPECT_NEAR(part.hi.x, 0.5f, 1e-6f);
  EXPECT_NEAR(part.hi.y, 1.0f, 1e-3f);
  EXPECT_EQ(part.lo.z, 0.5f);
}

TEST(Polygon, MeanValueCoordinatesReproduceThePoint) {
  Random random(8);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 point{random.between(0.1f, 0.9f), random.between(0.1f, 0.9f), 0};
    std::array<float, 6> weights;
    mean_value_coordinates(ell, point, weights);
    Vec3 mean(0.0f);
    float sum = 0.0f;
    for (std::size_t i = 0; i < ell.size(); ++i) {
      mean += weights[i] * ell[i];
      sum += weights[i];
    }
    ASSERT_NEAR(sum, 1.0f, 1e-5f);
    ASSERT_NEAR(glm::distance(mean, point), 0.0f, 1e-5f);
  }
}

TEST(Polygon, MeanValueCoordinatesOnAnEdgeBelongToItsEnds) {
  const std::array<Vec3, 4> square{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  std::array<float, 4> weights;
  mean_value_coordinates(square, {0.25f, 0, 0}, weights);
  EXPECT_EQ(weights, (std::array<float, 4>{0.75f, 0.25f, 0, 0}));
  mean_value_coordinates(square, {0, 0.25f, 0}, weights);
  EXPECT_EQ(weights, (std::array<float, 4>{0.75f, 0, 0, 0.25f}));
  mean_value_coordinates(square, {1, 1, 0}, weights);
  EXPECT_EQ(weights, (std::array<float, 4>{0, 0, 1, 0}));
}

}  // namespace
}  // namespace bspview
