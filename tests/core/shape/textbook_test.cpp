#include "core/shape/textbook.h"

#include <gtest/gtest.h>

#include <array>

#include "core/shape/triangle.h"
#include "core/shape/woop.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

constexpr int trials = 20000;
constexpr std::array<Sides, 2> both_rules{Sides::both, Sides::front};

Ray random_ray(test::Random& random) {
  const Vec3 origin = random.point(4.0f);
  return {origin, random.point(1.0f) - origin};
}

/// Answers that agree up to the rounding of float; `others` counts those that do not.
struct Comparison {
  int hits = 0, others = 0;

  void add(double tested, double exact) {
    const bool hit = exact != no_hit;
    hits += hit;
    const bool same = hit == (tested != no_hit) &&
                      (!hit || std::abs(tested - exact) <= 1e-3 * (1.0 + std::abs(exact)));
    others += !same;
  }
};

void expect_agreement(const Comparison& comparison) {
  EXPECT_GT(comparison.hits, trials / 50);
  EXPECT_LE(comparison.others, comparison.hits / 200);
}

TEST(Textbook, TrianglesAgreeWithTheExactTestWhereNothingIsClose) {
  for (const Sides sides : both_rules) {
    test::Random random(1);
    Comparison moeller_float, moeller_double, woop;
    for (int i = 0; i < trials; ++i) {
      const std::array<Vec3, 3> corners{random.point(1.0f), random.point(1.0f), random.point(1.0f)};
      const Ray ray = random_ray(random);
      const double exact = hit_triangle(RayQuery(ray), corners.data(), sides);
      moeller_float.add(hit_moeller_trumbore(TextbookRay<float>(ray), corners.data(), sides),
                        exact);
      moeller_double.add(hit_moeller_trumbore(TextbookRay<double>(ray), corners.data(), sides),
                         exact);
      woop.add(hit_woop(WoopRay(ray), corners.data(), sides), exact);
    }
    expect_agreement(moeller_float);
    expect_agreement(moeller_double);
    expect_agreement(woop);
    EXPECT_EQ(moeller_double.others, 0);
  }
}

TEST(Textbook, ConcavePolygonsAgreeWithTheExactTestWhereNothingIsClose) {
  const std::array<Vec3, 4> dart{Vec3(0, 0, 0), Vec3(2, -1, 0), Vec3(0.5f, 0, 0), Vec3(2, 1, 0)};
  for (const Sides sides : both_rules) {
    test::Random random(2);
    Comparison in_float, in_double;
    for (int i = 0; i < trials; ++i) {
      const Vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction()));
      std::array<Vec3, 4> corners;
      for (std::size_t k = 0; k < 4; ++k) corners[k] = dart[k].x * u + dart[k].y * v;
      const PolygonPlane plane = polygon_plane(corners);
      const Ray ray = random_ray(random);
      const double exact = hit_polygon(RayQuery(ray), corners, plane, sides);
      in_float.add(hit_polygon_crossings(TextbookRay<float>(ray), corners, plane, sides), exact);
      in_double.add(hit_polygon_crossings(TextbookRay<double>(ray), corners, plane, sides), exact);
    }
    expect_agreement(in_float);
    expect_agreement(in_double);
  }
}

TEST(Textbook, SpheresAndConesAgreeWithDoubleWhereNothingIsClose) {
  for (const Sides sides : both_rules) {
    test::Random random(3);
    Comparison spheres, cones;
    for (int i = 0; i < trials; ++i) {
      const float sign = random.below(2) == 0 ? 1.0f : -1.0f;
      const Sphere sphere{random.point(0.5f), sign * random.between(0.1f, 1.0f)};
      const Cone cone{random.point(0.5f), sign * random.between(0.1f, 1.0f), random.point(1.5f),
                      sign * random.between(0.0f, 1.0f)};
      const Ray ray = random_ray(random);
      const TextbookRay<float> textbook(ray);
      spheres.add(hit_sphere_textbook(textbook, sphere, sides),
                  hit_sphere(RayQuery(ray), sphere, sides));
      cones.add(hit_cone_textbook(textbook, cone, sides),
                hit_cone(RayQuery(ray), ConeFrame(cone), sides));
    }
    expect_agreement(spheres);
    expect_agreement(cones);
  }
}

TEST(Textbook, AFarSphereLosesItsRim) {
  const Sphere sphere{{0.0f, 0.0f, 0.0f}, 1.0f};
  test::Random random(4);
  int wrong = 0;
  for (int i = 0; i < trials; ++i) {
    const Vec3 origin = 10000.0f * random.direction();
    const Ray ray{origin, random.point(1.0f) - origin};
    const bool tested = hit_sphere_textbook(TextbookRay<float>(ray), sphere, Sides::both) != no_hit;
    const bool exact = hit_sphere(RayQuery(ray), sphere, Sides::both) != no_hit;
    wrong += tested != exact;
  }
  EXPECT_GT(wrong, trials / 20);
}

}  // namespace
}  // namespace bspview
