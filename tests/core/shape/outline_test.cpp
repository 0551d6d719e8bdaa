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

/// An outline that is divided again and again.
class DividedOutline {
 public:
  DividedOutline(std::span<const Vec3> polygon, const Aabb& cell)
      : part_(find_outline(polygon, box_around(polygon), cell, margin, found_)) {}

  Outline part() const { return part_; }
  Aabb box() const { return box_of(part_, margin); }

  struct Sides : OutlineSides {
    Aabb left_box, right_box;
  };
  Sides sides(int axis, float plane) {
    LaneBox left, right;
    OutlineCorner* const room = rooms_[turn_].of(2 * outline_room(part_.size()));
    const OutlineSides sides =
        divide(part_, lane_box(box()), {axis, plane, margin}, room, {left, right});
    turn_ = 1 - turn_;
    return {sides, aabb(left), aabb(right)};
  }

  /// Goes to one side of a random plane across the cell, which becomes that side.
  void go_down(test::Random& random, Aabb& cell) {
    const int axis = random.below(3);
    const float plane = cell.lo[axis] + random.unit() * (cell.hi[axis] - cell.lo[axis]);
    const Sides both = sides(axis, plane);
    const bool go_left = random.below(2) == 0;
    (go_left ? cell.hi : cell.lo)[axis] = plane;
    part_ = go_left ? both.left : both.right;
  }

 private:
  OutlineRooms found_;
  std::array<OutlineRoom, 2> rooms_;
  std::size_t turn_ = 0;
  Outline part_;
};

// Down a random path of cells, the outline stays what clipping the whole polygon gives.
TEST(Outline, CutAgainAndAgainIsTheClippedPolygon) {
  test::Random random(1);
  int kept = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const std::array<Vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    DividedOutline outline(corners, cube);
    Aabb cell = cube;
    for (int depth = 0; depth < 30 && !outline.part().empty(); ++depth, ++kept) {
      outline.go_down(random, cell);
      const Aabb box = intersection(outline.box(), cell);
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
    const Aabb whole = box_around(corners);
    const Aabb box = intersection(DividedOutline(corners, cell).box(), intersection(cell, whole));
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
    DividedOutline outline(star.corners, cube);
    Aabb cell = cube;
    for (int depth = 0; depth < 12; ++depth) {
      outline.go_down(random, cell);
      const Aabb box = grown(outline.box(), 1e-6f);
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
  DividedOutline outline(corners, cube);
  DividedOutline::Sides sides = outline.sides(0, 0.5f);
  EXPECT_FALSE(sides.left.empty());
  EXPECT_FALSE(sides.right.empty());
  sides = outline.sides(2, 0.0f);  // lies in the plane
  EXPECT_EQ(sides.left.size(), 3u);
  EXPECT_EQ(sides.right.size(), 3u);
  sides = outline.sides(1, -0.1f);
  EXPECT_TRUE(sides.left.empty());
}

TEST(Outline, BoxesOfSidesEndAtThePlaneAndWithinTheWhole) {
  test::Random random(4);
  for (int trial = 0; trial < 3000; ++trial) {
    const std::array<Vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    DividedOutline outline(corners, cube);
    const Aabb whole = outline.box();
    const int axis = random.below(3);
    const float plane = whole.lo[axis] + random.unit() * (whole.hi[axis] - whole.lo[axis]);
    const DividedOutline::Sides sides = outline.sides(axis, plane);
    ASSERT_TRUE(whole.contains(sides.left_box) && whole.contains(sides.right_box));
    ASSERT_EQ(sides.left_box.hi[axis], plane) << trial;
    ASSERT_EQ(sides.right_box.lo[axis], plane) << trial;
  }
}

TEST(Outline, OfManyCornersIsTheClippedPolygon) {
  test::Random random(5);
  std::vector<Vec3> circle;
  for (int i = 0; i < 144; ++i) {
    const float angle = static_cast<float>(i) * 6.2831853f / 144.0f;
    circle.push_back({std::cos(angle), std::sin(angle), 0.5f * std::cos(angle)});
  }
  int kept = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    DividedOutline outline(circle, cube);
    EXPECT_EQ(outline.part().size(), circle.size());
    Aabb cell = cube;
    for (int depth = 0; depth < 20 && !outline.part().empty(); ++depth, ++kept) {
      outline.go_down(random, cell);
      const Aabb expected = clip_polygon(circle, cell);
      const Aabb divided = intersection(outline.box(), cell);
      const Aabb found = intersection(DividedOutline(circle, cell).box(), cell);
      for (const Aabb& box : {divided, found}) {
        ASSERT_TRUE(expected.empty() || box.contains(expected)) << trial << " at " << depth;
        ASSERT_TRUE(box.empty() || grown(expected, 1e-6f).contains(box)) << trial << " " << depth;
      }
    }
  }
  EXPECT_GT(kept, 2'000);
}

// Every tooth is cut off from the others: as many crossings as there can be.
TEST(Outline, OfAComb) {
  std::vector<Vec3> comb;
  for (int tooth = 0; tooth < 50; ++tooth) {
    const float x = static_cast<float>(tooth) / 50.0f;
    comb.insert(comb.end(), {{x, -1, 0}, {x + 0.01f, 1, 0}});
  }
  DividedOutline outline(comb, cube);
  const DividedOutline::Sides sides = outline.sides(1, 0.0f);
  EXPECT_EQ(sides.left.size(), 150u);
  EXPECT_EQ(sides.right.size(), 150u);
  EXPECT_EQ(DividedOutline(comb, {Vec3(-1.0f), {1, 0, 1}}).part().size(), 150u);
}

}  // namespace
}  // namespace bspview
