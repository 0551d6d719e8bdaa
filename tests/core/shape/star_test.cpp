#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/shape/polygon.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random.h"

// Polygons of many corners, whose edges are counted by vectors and in blocks of 64.
namespace bspview {
namespace {

using test::Random;

class StarTest : public testing::TestWithParam<std::int64_t> {
  test::OneInstructionSet set_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(EverySet, StarTest, testing::ValuesIn(test::instruction_sets()),
                         [](const auto& set) { return hwy::TargetName(set.param); });

/// Around the counts at which the corners are looked at in another way.
constexpr int corner_counts[] = {3, 12, 13, 63, 64, 65, 128, 129, 200};

/// The first corner is in any direction, so that a crossing may be at any of them.
std::vector<Vec2> make_star(int corners, Random& random) {
  const float turn = random.unit();
  std::vector<Vec2> star;
  for (int i = 0; i < corners; ++i) {
    const float place = (static_cast<float>(i) + random.between(-0.4f, 0.4f)) / corners;
    const float angle = 2.0f * std::numbers::pi_v<float> * (turn + place);
    star.push_back(random.between(0.3f, 1.0f) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return star;
}

struct Plane {
  Vec3 centre, u, v;

  Vec3 at(Vec2 p) const { return centre + p.x * u + p.y * v; }
  Vec3 normal() const { return glm::cross(u, v); }
};

/// Across each axis, then tilted.
Plane make_plane(int trial, Random& random) {
  const int across = trial % 4;
  Plane plane{random.point(1.0f), Vec3(0.0f), Vec3(0.0f)};
  if (across < 3) {
    plane.u[(across + 1) % 3] = 1.0f;
    plane.v[(across + 2) % 3] = 1.0f;
  } else {
    plane.u = random.direction();
    plane.v = glm::normalize(glm::cross(plane.u, random.direction()));
  }
  return plane;
}

/// Straight through the plane or aslant.
Ray ray_through(Vec3 target, const Plane& plane, Random& random) {
  const Vec3 way = random.below(2) == 0 ? plane.normal() : random.direction();
  const Vec3 origin = target + random.between(0.5f, 4.0f) * way;
  return {origin, target - origin};
}

/// A star in space.
struct Face {
  Face(const std::vector<Vec2>& star, const Plane& plane) {
    for (const Vec2 corner : star) corners.push_back(plane.at(corner));
    for (const Vec3& corner : corners) box.grow(corner);
    its_plane = polygon_plane(corners);
  }

  double hit(const Ray& ray) const {
    return hit_polygon(RayQuery(ray, reach_of(box, ray.origin)), corners, its_plane, Sides::both);
  }
  /// Without a reach no rounding is bounded, and every test is decided exactly.
  double exact_hit(const Ray& ray) const {
    return hit_polygon(RayQuery(ray), corners, its_plane, Sides::both);
  }

  std::vector<Vec3> corners;
  Aabb box;
  PolygonPlane its_plane;
};

double distance_to_edge(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 edge = to - from, arm = point - from;
  const float share = std::clamp(glm::dot(arm, edge) / glm::dot(edge, edge), 0.0f, 1.0f);
  return glm::length(arm - share * edge);
}

double distance_to_outline(Vec2 point, const std::vector<Vec2>& star) {
  double distance = 10.0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vec2 to = star[(i + 1) % star.size()];
    distance = std::min(distance, distance_to_edge(point, star[i], to));
  }
  return distance;
}

bool even_odd(Vec2 point, const std::vector<Vec2>& star) {
  bool inside = false;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vec2 a = star[i], b = star[(i + 1) % star.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    const double share = (double(point.y) - a.y) / (double(b.y) - a.y);
    if (a.x + share * (double(b.x) - a.x) > point.x) inside = !inside;
  }
  return inside;
}

TEST_P(StarTest, IsHitWhereEdgesBesideThePointAreOdd) {
  for (const int corners : corner_counts) {
    Random random(static_cast<std::uint64_t>(corners));
    int inside = 0, outside = 0;
    for (int trial = 0; trial < 3000; ++trial) {
      const std::vector<Vec2> star = make_star(corners, random);
      const Plane plane = make_plane(trial, random);
      const Vec2 point(random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f));
      const Ray ray = ray_through(plane.at(point), plane, random);
      const double slope = glm::dot(glm::normalize(ray.direction), plane.normal());
      if (std::abs(slope) < 0.05 || distance_to_outline(point, star) < 1e-3) continue;
      const bool expected = even_odd(point, star);
      const double t = Face(star, plane).hit(ray);
      ASSERT_EQ(t != no_hit, expected) << corners << " corners, trial " << trial;
      ASSERT_NEAR(expected ? t : 1.0, 1.0, 1e-4) << corners << " corners, trial " << trial;
      (expected ? inside : outside) += 1;
    }
    EXPECT_GT(inside, 200) << corners;
    EXPECT_GT(outside, 200) << corners;
  }
}

/// On an edge or beside it; as far as a corner on one axis; anywhere.
Vec2 point_by_outline(const std::vector<Vec2>& star, Random& random) {
  const auto i = static_cast<std::size_t>(random.below(static_cast<int>(star.size())));
  const Vec2 from = star[i], to = star[(i + 1) % star.size()];
  const Vec2 anywhere(random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f));
  constexpr float beside[] = {0.0f, 1e-7f, 1e-6f, 1e-3f};
  const float share = random.below(4) == 0 ? 0.0f : random.unit();
  switch (random.below(4)) {
    case 0:
      return Vec2(from.x, anywhere.y);
    case 1:
      return Vec2(anywhere.x, from.y);
    default:
      return from + share * (to - from) + beside[random.below(4)] * anywhere;
  }
}

TEST_P(StarTest, IsHitAsDecidedExactlyByItsEdgesAndAtTheHeightOfItsCorners) {
  for (const int corners : corner_counts) {
    Random random(static_cast<std::uint64_t>(corners));
    int hits = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      const std::vector<Vec2> star = make_star(corners, random);
      const Plane plane = make_plane(trial, random);
      const Ray ray = ray_through(plane.at(point_by_outline(star, random)), plane, random);
      const Face face(star, plane);
      const double exact = face.exact_hit(ray);
      ASSERT_EQ(face.hit(ray), exact) << corners << " corners, trial " << trial;
      hits += exact != no_hit;
    }
    EXPECT_GT(hits, 1000) << corners;
    EXPECT_LT(hits, 3000) << corners;
  }
}

}  // namespace
}  // namespace bspview
