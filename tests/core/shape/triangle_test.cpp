#include "core/shape/triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/exact.h"
#include "core/shape/polygon.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;
using Corners = std::array<Vec3, 3>;

double hit(const Ray& ray, const Corners& corners, Sides sides = Sides::both) {
  return hit_triangle(RayQuery(ray), corners.data(), sides);
}

TEST(Triangle, RayAimedInsideHitsWithTheDistanceOfThePoint) {
  Random random(1);
  for (int trial = 0; trial < 100000; ++trial) {
    const Corners corners{random.point(1), random.point(1), random.point(1)};
    const float u = random.between(0.05f, 0.45f), v = random.between(0.05f, 0.45f);
    const Vec3 target = (1 - u - v) * corners[0] + u * corners[1] + v * corners[2];
    const Vec3d normal = triangle_normal(corners[0], corners[1], corners[2]);
    const Vec3 origin = 3.0f * random.direction();
    const Vec3d way = Vec3d(target) - Vec3d(origin);
    const double slant = std::abs(glm::dot(glm::normalize(normal), glm::normalize(way)));
    if (glm::length(normal) < 0.05 || slant < 0.05) continue;
    const Ray ray{origin, target - origin};
    const double found = hit(ray, corners);
    ASSERT_NE(found, no_hit) << "trial " << trial;
    ASSERT_NEAR(found, 1.0, 2e-6 / slant) << "trial " << trial;
    const Vec2 weights = triangle_weights(ray, corners.data());
    ASSERT_NEAR(weights.x, u, 2e-4);
    ASSERT_NEAR(weights.y, v, 2e-4);
  }
}

// T04: contraction (a fused multiply-add) would break this.
TEST(Triangle, EdgeAreaIsAntisymmetricToTheLastBit) {
  Random random(2);
  for (int trial = 0; trial < 1000000; ++trial) {
    const Vec2 p{random.between(-1, 1), random.between(-1, 1)};
    const Vec2 q{random.between(-1, 1), random.between(-1, 1)};
    ASSERT_EQ(edge_area(p, q), -edge_area(q, p));
  }
}

Aabb box_of(const Corners& corners) {
  Aabb box;
  for (const Vec3& corner : corners) box.grow(corner);
  return box;
}

Aabb random_cell(Random& random) {
  Aabb cell;
  cell.grow(random.point(1.0f));
  cell.grow(random.point(1.0f));
  return cell;
}

TEST(ClipTriangle, HoldsThePartInACellAndLittleMore) {
  Random random(7);
  double exact = 0.0, found = 0.0, uncut = 0.0;
  for (int trial = 0; trial < 100000; ++trial) {
    const float scale = std::ldexp(1.0f, random.below(200) - 100);
    Corners corners{scale * random.point(1), scale * random.point(1), scale * random.point(1)};
    if (trial % 4 == 0) corners[1].x = corners[0].x;  // an edge along two faces
    if (trial % 8 == 0) corners[2].x = corners[0].x;  // all of it
    if (trial % 32 == 1) corners[2] = corners[1];
    if (trial % 32 == 2) {  // small and far away
      for (Vec3& corner : corners) corner = scale * Vec3(100.0f) + 1e-4f * corner;
    }
    Aabb cell = random_cell(random);
    cell = {scale * cell.lo, scale * cell.hi};
    if (trial % 32 == 2) cell = {corners[0], corners[0] + scale * 1e-4f};
    if (trial % 32 == 5) cell.hi.z = cell.lo.z;
    if (trial % 16 == 0) cell.hi.x = std::max(cell.lo.x, corners[0].x);  // touched
    const Aabb whole = box_of(corners), overlap = intersection(whole, cell);
    const Aabb part = clip_polygon(corners, cell);
    const Aabb clipped = clip_triangle(corners.data(), whole, cell);
    if (part.empty()) continue;
    ASSERT_TRUE(clipped.contains(part)) << "trial " << trial;
    ASSERT_TRUE(overlap.contains(clipped)) << "trial " << trial;
    const auto area = [&](const Aabb& box) { return half_area({box.lo / scale, box.hi / scale}); };
    exact += area(part);
    found += area(clipped);
    uncut += area(overlap);
  }
  EXPECT_LT(found - exact, 0.3 * (uncut - exact));
}

TEST(ClipTriangle, IsEmptyWhereTheBoxOrTheTriangleIsNotInTheCell) {
  const Corners corners{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const Aabb whole = box_of(corners);
  EXPECT_TRUE(clip_triangle(corners.data(), whole, {Vec3(5), Vec3(6)}).empty());
  EXPECT_TRUE(clip_triangle(corners.data(), whole, {{3, 3, -1}, {4, 4, 1}}).empty());
  EXPECT_FALSE(clip_triangle(corners.data(), whole, {{2, 2, -1}, {4, 4, 1}}).empty());
}

TEST(Triangle, BoundedReachDecidesAsExactArithmeticDoes) {
  Random random(3);
  int hits = 0;
  for (int trial = 0; trial < 300000; ++trial) {
    const Vec3 centre = random.point(trial % 2 == 0 ? 1.0f : 1000.0f);
    const float size = std::pow(10.0f, random.between(-4.0f, 0.0f));
    Corners corners;
    for (Vec3& corner : corners) corner = centre + random.point(size);
    // Aimed at an edge, a vertex or near by, so that roundings count.
    const float s = std::array{0.0f, 1.0f, random.unit()}[static_cast<std::size_t>(trial % 3)];
    const Vec3 target = corners[0] + s * (corners[1] - corners[0]);
    const Vec3 origin = centre + 3.0f * random.direction();
    const Ray ray{origin, target - origin};
    const double fast = hit_triangle(RayQuery(ray, 8.0f), corners.data(), Sides::both);
    const double exact = hit_triangle_exactly(RayQuery(ray), corners.data(), Sides::both);
    ASSERT_EQ(fast, exact) << trial;
    hits += exact != no_hit;
  }
  EXPECT_GT(hits, 50000);
}

TEST(Triangle, TwoThatShareAnEdgeLeaveNoGap) {
  Random random(4);
  for (int trial = 0; trial < 200000; ++trial) {
    const Vec3 a = random.point(1), b = random.point(1);
    const Corners left{a, b, random.point(1)}, right{b, a, random.point(1)};
    const float s = random.between(0.0f, 1.0f);
    const Vec3 target = a + s * (b - a);
    const Ray ray{3.0f * random.direction(), {}};
    const Ray aimed{ray.origin, target - ray.origin};
    // Seen along the ray, the third corners must lie on opposite sides of the shared edge.
    const Vec3d edge = glm::cross(Vec3d(a - ray.origin), Vec3d(b - ray.origin));
    const double side_left = glm::dot(edge, Vec3d(left[2] - ray.origin));
    const double side_right = glm::dot(edge, Vec3d(right[2] - ray.origin));
    if (side_left * side_right >= 0.0) continue;
    ASSERT_TRUE(hit(aimed, left) != no_hit || hit(aimed, right) != no_hit) << trial;
  }
}

TEST(Triangle, OneSidedIsSeenFromTheCounterClockwiseSideOnly) {
  const Corners corners{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  const Ray from_front{{0.2f, 0.2f, 1}, {0, 0, -1}}, from_behind{{0.2f, 0.2f, -1}, {0, 0, 1}};
  EXPECT_EQ(hit(from_front, corners, Sides::front), 1.0);
  EXPECT_EQ(hit(from_behind, corners, Sides::front), no_hit);
  EXPECT_EQ(hit(from_behind, corners, Sides::both), 1.0);
}

TEST(Triangle, CollinearAndNonFiniteOnesAreMissed) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const Ray ray{{0.25f, 0.25f, 1}, {0, 0, -1}};
  EXPECT_EQ(hit(ray, {Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{2, 2, 0}}), no_hit);
  EXPECT_EQ(hit(ray, {Vec3{0.25f}, Vec3{0.25f}, Vec3{0.25f}}), no_hit);
  for (const float bad : {nan, inf, -inf}) {
    EXPECT_EQ(hit(ray, {Vec3{0, 0, 0}, Vec3{bad, 0, 0}, Vec3{0, 1, 0}}), no_hit) << bad;
    EXPECT_EQ(hit(ray, {Vec3{0, 0, bad}, Vec3{1, 0, bad}, Vec3{0, 1, bad}}), no_hit) << bad;
  }
}

TEST(Triangle, OutsideTheIntervalIsNoHit) {
  const Corners corners{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  Ray ray{{0.2f, 0.2f, 1}, {0, 0, -2}};
  EXPECT_EQ(hit(ray, corners), 0.5);
  ray.t_max = 0.5f;
  EXPECT_EQ(hit(ray, corners), no_hit);
  ray.t_max = 1.0f;
  ray.t_min = 0.5f;
  EXPECT_EQ(hit(ray, corners), no_hit);
}

TEST(Triangle, DoubleReferenceAgreesAwayFromEdges) {
  Random random(5);
  for (int trial = 0; trial < 100000; ++trial) {
    const Corners corners{random.point(1), random.point(1), random.point(1)};
    const Ray ray{3.0f * random.direction(), random.direction()};
    const double one = hit(ray, corners);
    const double two = hit_triangle_double(RayQuery(ray), corners.data(), Sides::both);
    const Vec2 weights = triangle_weights(ray, corners.data());
    const float border = std::min({weights.x, weights.y, 1.0f - weights.x - weights.y});
    if ((one == no_hit && two == no_hit) || border < 1e-3f) continue;
    ASSERT_NEAR(one, two, 1e-6 * std::abs(two)) << trial;
  }
}

TEST(Triangle, DistancesAreRightNextToThePlane) {
  Random random(21);
  for (int trial = 0; trial < 20000; ++trial) {
    const std::array<Vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    const float s = random.unit(), t = random.unit() * (1 - s);
    // In the plane but for rounding.
    const Vec3 origin = corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
    Ray ray{.origin = origin, .direction = random.direction()};
    ray.t_min = -std::numeric_limits<float>::infinity();
    if (exact_slope_sign(ray.direction, corners.data()) == 0) continue;
    const double exact = exact_plane_distance(origin, ray.direction, corners.data());
    const double found = hit_triangle_plane(RayQuery(ray, 4.0f), corners.data(), Sides::both);
    ASSERT_LE(std::abs(found - exact), 0x1p-23 * std::abs(exact)) << trial;
  }
}

}  // namespace
}  // namespace bspview
