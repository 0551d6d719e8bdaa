#include "core/math/exact.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;
using Rational = boost::multiprecision::cpp_rational;
using RationalVec = std::array<Rational, 3>;

RationalVec difference(Vec3 a, Vec3 b) {
  return {Rational(a.x) - Rational(b.x), Rational(a.y) - Rational(b.y),
          Rational(a.z) - Rational(b.z)};
}
RationalVec cross(const RationalVec& a, const RationalVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const RationalVec& a, const RationalVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Coordinates of very different sizes.
Vec3 wild_point(Random& random) {
  const auto wild = [&] { return std::ldexp(random.between(-1.0f, 1.0f), random.below(60) - 30); };
  const float x = wild(), y = wild();
  return {x, y, wild()};
}

TEST(Exact, SidesAreTheSignsOfTheRationalDeterminants) {
  Random random(71);
  int open = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    const bool wild = trial % 2 == 0;
    const Vec3 o = wild ? wild_point(random) : random.point(1.0f);
    const Vec3 a = wild ? wild_point(random) : random.point(1.0f);
    const Vec3 b = random.point(1.0f);
    // Aimed at the edge: the determinant nearly vanishes, or does.
    const float s = trial % 3 == 0 ? 0.0f : random.unit();
    const Vec3 d = a + s * (b - a) - o;
    const Rational det = dot(difference(d, Vec3(0.0f)), cross(difference(a, o), difference(b, o)));
    const int sign = det > 0 ? 1 : det < 0 ? -1 : 0;
    ASSERT_EQ(side_of_edge(o, d, a, b), sign) << trial;
    open += sign == 0;

    const RationalVec way = difference(a, o);
    const Rational minor = way[1] * Rational(d.z) - way[2] * Rational(d.y);
    ASSERT_EQ(side_of_line(o, d, a, 1, 2), minor > 0 ? 1 : minor < 0 ? -1 : 0) << trial;
  }
  EXPECT_GT(open, 0);
}

TEST(Exact, PlaneDistanceIsTheRationalOneRounded) {
  Random random(72);
  for (int trial = 0; trial < 3000; ++trial) {
    const std::array<Vec3, 3> triangle{wild_point(random), wild_point(random), wild_point(random)};
    const Vec3 o = wild_point(random), d = wild_point(random);
    const RationalVec normal =
        cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
    const Rational slope = dot(normal, difference(d, Vec3(0.0f)));
    ASSERT_EQ(exact_slope_sign(d, triangle.data()), slope > 0 ? 1 : slope < 0 ? -1 : 0);
    if (slope == 0) continue;
    const Rational t = dot(normal, difference(triangle[0], o)) / slope;
    ASSERT_DOUBLE_EQ(exact_plane_distance(o, d, triangle.data()), t.convert_to<double>());
  }
}

}  // namespace
}  // namespace bspview
