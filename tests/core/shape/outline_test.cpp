#include "core/shape/outline.h"

#include <gtest/gtest.h>

#include "core/shape/polygon.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

Aabb box_around(std::span<const Vec3> corners) {
  Aabb box;
  for (const Vec3& corner : corners) box.grow(corner);
  return box;
}

Aabb grown(const Aabb& box, float margin) {
  return box.empty() ? box : Aabb{box.lo - Vec3(margin), box.hi + Vec3(margin)};
}

const Aabb cube{Vec3(-1.0f), Vec3(1.0f)};
const double margin = outline_margin(cube);

// Down a random path of cells, the outline stays what clipping the whole polygon gives.
TEST(Outline, CutAgainAndAgainIsTheClippedPolygon) {
  test::Random random(1);
  int kept = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const std::array<Vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    Outline part, left, right;
    ASSERT_TRUE(find_outline(corners, box_around(corners), cube, margin, part));
    Aabb cell = cube;
    for (int depth = 0; depth < 30 && part.size > 0; ++depth, ++kept) {
      const int axis = random.below(3);
      const float plane = cell.lo[axis] + random.unit() * (cell.hi[axis] - cell.lo[axis]);
      ASSERT_TRUE(divide(part, {axis, plane, margin}, {left, right}));
      const bool go_left = random.below(2) == 0;
      (go_left ? cell.hi : cell.lo)[axis] = plane;
      part = go_left ? left : right;
      const Aabb box = intersection(box_of(part, margin), cell);
      const Aabb expected = clip_polygon(corners, cell);
      ASSERT_TRUE(expected.empty() || box.contains(expected)) << trial << " at " << depth;
      ASSERT_TRUE(box.empty() || grown(expected, 1e-6f).contains(box)) << trial << " at " << depth;
    }
  }
  EXPECT_GT(kept, 10'000);
}

TEST(Outline, OfAPartIsTheClippedPolygon) {
  test::Random random(2);
  for (int trial = 0; trial < 3000; ++trial) {
    const std::array<Vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    const Vec3 lo = random.point(0.7f);
    const Aabb cell{lo, lo + Vec3(0.3f)};
    Outline part;
    ASSERT_TRUE(find_outline(corners, box_around(corners), cell, margin, part));
    const Aabb box = intersection(box_of(part, margin), intersection(cell, box_around(corners)));
    const Aabb expected = clip_polygon(corners, cell);
    ASSERT_TRUE(expected.empty() || box.contains(expected)) << trial;
    ASSERT_TRUE(box.empty() || grown(expected, 1e-6f).contains(box)) << trial;
  }
}

// A star of ten corners around `points`.front(), and points on it.
struct Star {
  std::array<Vec3, 10> corners;
  std::vector<Vec3> points;
};

Star random_star(test::Random& random) {
  Star star;
  const Vec3 centre = random.point(0.3f), u = random.point(0.5f), v = random.point(0.5f);
  for (std::size_t i = 0; i < star.corners.size(); ++i) {
    const float angle = 0.62831853f * static_cast<float>(i);
    const float size = i % 2 == 0 ? 1.0f : 0.2f;
    star.corners[i] = centre + size * (std::cos(angle) * u + std::sin(angle) * v);
  }
  for (int i = 0; i < 300; ++i) {
    const std::size_t corner = static_cast<std::size_t>(random.below(10));
    const Vec3 edge = star.corners[(corner + 1) % 10] - star.corners[corner];
    const Vec3 end = star.corners[corner] + random.unit() * edge;
    star.points.push_back(centre + random.unit() * (end - centre));
  }
  return star;
}

TEST(Outline, OfAConcavePolygonHoldsEveryPointOfIt) {
  test::Random random(3);
  int seen = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Star star = random_star(random);
    Outline part, left, right;
    ASSERT_TRUE(find_outline(star.corners, box_around(star.corners), cube, margin, part));
    Aabb cell = cube;
    for (int depth = 0; depth < 12; ++depth) {
      const int axis = random.below(3);
      const float plane = cell.lo[axis] + random.unit() * (cell.hi[axis] - cell.lo[axis]);
      if (!divide(part, {axis, plane, margin}, {left, right})) break;
      const bool go_left = random.below(2) == 0;
      (go_left ? cell.hi : cell.lo)[axis] = plane;
      part = go_left ? left : right;
      const Aabb box = grown(box_of(part, margin), 1e-6f);
      for (const Vec3 point : star.points) {
        if (!grown(cell, -1e-6f).contains(point)) continue;
        ASSERT_TRUE(box.contains(point)) << trial << " at " << depth;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 50'000);
}

TEST(Outline, WhatOnlyTouchesThePlaneIsOnBothSides) {
  const std::array<Vec3, 3> corners{Vec3{0, 0, 0}, Vec3{0.5f, 0, 0}, Vec3{0, 0.5f, 0}};
  Outline whole, left, right;
  ASSERT_TRUE(find_outline(corners, box_around(corners), cube, margin, whole));
  ASSERT_TRUE(divide(whole, {0, 0.5, margin}, {left, right}));
  EXPECT_GT(left.size, 0u);
  EXPECT_GT(right.size, 0u);
  ASSERT_TRUE(divide(whole, {2, 0.0, margin}, {left, right}));  // lies in the plane
  EXPECT_EQ(left.size, 3u);
  EXPECT_EQ(right.size, 3u);
  ASSERT_TRUE(divide(whole, {1, -0.1, margin}, {left, right}));
  EXPECT_EQ(left.size, 0u);
  EXPECT_TRUE(box_of(left, margin).empty());
}

TEST(Outline, ManyCornersAreHeldOnlyWhereFewAreLeft) {
  std::vector<Vec3> circle;
  for (int i = 0; i < 144; ++i) {
    const float angle = static_cast<float>(i) * 6.2831853f / 144.0f;
    circle.push_back({std::cos(angle), std::sin(angle), 0.5f});
  }
  Outline part;
  EXPECT_FALSE(find_outline(circle, box_around(circle), cube, margin, part));
  const Aabb corner{{0.7f, 0.7f, 0.0f}, Vec3(1.0f)};
  ASSERT_TRUE(find_outline(circle, box_around(circle), corner, margin, part));
  EXPECT_GT(part.size, 3u);
}

}  // namespace
}  // namespace bspview
