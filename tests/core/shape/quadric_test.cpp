// Spheres and cones: against the same equations in 113-bit arithmetic.

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <vector>

#include "core/shape/cone.h"
#include "core/shape/sphere.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;
using Quad = boost::multiprecision::cpp_bin_float_quad;
using QuadVec = std::array<Quad, 3>;

QuadVec quad(Vec3 v) {
  return {v.x, v.y, v.z};
}
QuadVec sub(const QuadVec& a, const QuadVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Quad dot(const QuadVec& a, const QuadVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct QuadRoots {
  Quad first, second;
  Quad margin;  ///< discriminant over its largest term: how surely there are roots
};

std::optional<QuadRoots> solve(Quad a, Quad b, Quad c) {
  const Quad discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const Quad root = sqrt(discriminant);
  Quad first = (b - root) / a, second = (b + root) / a;
  if (first > second) std::swap(first, second);
  return QuadRoots{first, second, discriminant / (b * b)};
}

std::optional<QuadRoots> exact_sphere(const Ray& ray, const Sphere& sphere) {
  const QuadVec f = sub(quad(ray.origin), quad(sphere.centre)), d = quad(ray.direction);
  const Quad r = sphere.radius;
  return solve(dot(d, d), -dot(f, d), dot(f, f) - r * r);
}

TEST(Sphere, FarAwayItIsHitWithinAnUlpOfFloat) {
  Random random(11);
  int hits = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const float distance = std::pow(10.0f, random.between(0.5f, 6.0f));
    const Sphere sphere{random.point(1.0f), random.between(0.5f, 2.0f)};
    const Vec3 origin = sphere.centre + distance * random.direction();
    const Vec3 target = sphere.centre + 1.2f * sphere.radius * random.direction();
    const Ray ray{origin, target - origin};
    const auto exact = exact_sphere(ray, sphere);
    const double found = hit_sphere(RayQuery(ray), sphere, Sides::both);
    // Tangents closer than rounding can tell are left open.
    const Quad closest = exact ? exact->margin : 0;
    if (exact && closest * distance * distance < 1e-3) continue;
    if (!exact && found == no_hit) continue;
    ASSERT_TRUE(exact.has_value()) << trial;
    ASSERT_NE(found, no_hit) << trial << " " << distance;
    const double expected = static_cast<double>(exact->first);
    ASSERT_NEAR(found, expected, 0x1p-24 * expected) << trial;
    ++hits;
  }
  EXPECT_GT(hits, 10000);
}

TEST(Sphere, FromInsideTheFarSideIsHit) {
  const Sphere sphere{{1, 2, 3}, 2.0f};
  EXPECT_DOUBLE_EQ(hit_sphere(RayQuery({{1, 2, 3}, {0, 0, 1}}), sphere, Sides::both), 2.0);
  EXPECT_EQ(hit_sphere(RayQuery({{1, 2, 3}, {0, 0, 1}}), sphere, Sides::front), no_hit);
}

TEST(Sphere, NegativeRadiusShowsTheInsideOnly) {
  const Sphere sphere{{0, 0, 0}, -1.0f};
  EXPECT_EQ(hit_sphere(RayQuery({{0, 0, -3}, {0, 0, 1}}), sphere, Sides::front), 4.0);
  EXPECT_EQ(hit_sphere(RayQuery({{0, 0, -3}, {0, 0, 1}}), sphere, Sides::both), 2.0);
}

TEST(Sphere, ClippingDropsCellsInsideAndOutsideTheBall) {
  const Sphere sphere{{0, 0, 0}, 1.0f};
  EXPECT_TRUE(clip_sphere(sphere, {Vec3(-0.1f), Vec3(0.1f)}).empty());
  EXPECT_TRUE(clip_sphere(sphere, {Vec3(0.7f), Vec3(1.0f)}).empty());
  EXPECT_FALSE(clip_sphere(sphere, {Vec3(0.5f), Vec3(0.7f)}).empty());
  EXPECT_FALSE(clip_sphere(sphere, {{-1, -1, 1}, {1, 1, 2}}).empty());  // touches the pole
}

/// Roots of the ray and the unbounded cone, each with its place s along the axis.
struct QuadConeHit {
  Quad t, s;
};
std::vector<QuadConeHit> exact_cone(const Ray& ray, const Cone& cone) {
  const QuadVec base = quad(cone.base), axis = sub(quad(cone.apex), base);
  const QuadVec f = sub(quad(ray.origin), base), d = quad(ray.direction);
  const Quad axis2 = dot(axis, axis), m = dot(f, axis) / axis2, n = dot(d, axis) / axis2;
  const Quad radius = abs(Quad(cone.base_radius));
  const Quad growth = abs(Quad(cone.apex_radius)) - radius;
  const Quad at = radius + growth * m, slope = growth * n;
  const Quad a = dot(d, d) - n * n * axis2 - slope * slope;
  const Quad b = at * slope - (dot(f, d) - m * n * axis2);
  const Quad c = dot(f, f) - m * m * axis2 - at * at;
  const auto roots = solve(a, b, c);
  if (!roots) return {};
  return {{roots->first, m + roots->first * n}, {roots->second, m + roots->second * n}};
}

TEST(Cone, FarAwayItIsHitWithinAnUlpOfFloat) {
  Random random(12);
  int hits = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const float distance = std::pow(10.0f, random.between(0.5f, 5.0f));
    const Vec3 base = random.point(1.0f);
    const Cone cone{base, random.between(0.1f, 1.0f),
                    base + random.between(0.5f, 2) * random.direction(),
                    trial % 3 == 0 ? 0.0f : random.between(0.0f, 1.0f)};
    const Vec3 origin = base + distance * random.direction();
    const Ray ray{origin, base + random.point(1.0f) - origin};
    const double found = hit_cone(RayQuery(ray), ConeFrame(cone), Sides::both);
    std::optional<QuadConeHit> exact;
    bool open = false;  // an end or a tangent too near to call
    const auto roots = exact_cone(ray, cone);
    for (const QuadConeHit& root : roots) {
      open |= abs(root.s) < 1e-9 || abs(root.s - 1) < 1e-9;
      if (!exact && root.s >= 0 && root.s <= 1 && root.t > 0) exact = root;
    }
    if (roots.size() == 2 && abs(roots[0].t - roots[1].t) * distance < 1e-4) open = true;
    if (open) continue;
    ASSERT_EQ(found != no_hit, exact.has_value()) << "trial " << trial;
    if (!exact) continue;
    const double expected = static_cast<double>(exact->t);
    ASSERT_NEAR(found, expected, 0x1p-24 * expected) << "trial " << trial;
    ++hits;
  }
  EXPECT_GT(hits, 10000);
}

TEST(Cone, EndsAreOpen) {
  const Cone cylinder{{0, 0, 0}, 1.0f, {0, 0, 2}, 1.0f};
  EXPECT_EQ(hit_cone(RayQuery({{0.5f, 0, 5}, {0, 0, -1}}), ConeFrame(cylinder), Sides::both),
            no_hit);
  EXPECT_EQ(hit_cone(RayQuery({{3, 0, 1}, {-1, 0, 0}}), ConeFrame(cylinder), Sides::both), 2.0);
  EXPECT_EQ(hit_cone(RayQuery({{3, 0, 2.5f}, {-1, 0, 0}}), ConeFrame(cylinder), Sides::both),
            no_hit);
}

TEST(Cone, RayAlongAGeneratorMeetsTheOtherSideOnce) {
  const Cone cone{{0, 0, 0}, 1.0f, {0, 0, 1}, 0.0f};
  // Parallel to the generator through (-1, 0, 0) and (0, 0, 1), from below through the base.
  const double found =
      hit_cone(RayQuery({{-0.5f, 0, -0.5f}, {1, 0, 1}}), ConeFrame(cone), Sides::both);
  EXPECT_NEAR(found, 1.0, 1e-12);
}

TEST(Cone, OneSidedFollowsTheSignOfTheRadii) {
  const Ray across{{3, 0, 1}, {-1, 0, 0}};
  EXPECT_EQ(hit_cone(RayQuery(across), ConeFrame({{0, 0, 0}, 1, {0, 0, 2}, 1}), Sides::front), 2.0);
  EXPECT_EQ(hit_cone(RayQuery(across), ConeFrame({{0, 0, 0}, -1, {0, 0, 2}, -1}), Sides::front),
            4.0);
}

TEST(Cone, BoxesHoldTheSurface) {
  Random random(13);
  for (int trial = 0; trial < 2000; ++trial) {
    const Cone cone{random.point(1), random.between(0, 0.5f), random.point(1),
                    random.between(0, 0.5f)};
    const Vec3 lo = random.point(0.8f);
    const Aabb cell{lo, lo + Vec3(0.6f)}, bounds = cone_bounds(cone), part = clip_cone(cone, cell);
    const Vec3d axis = Vec3d(cone.apex) - Vec3d(cone.base);
    const Vec3d u = glm::normalize(glm::cross(axis, Vec3d(random.direction())));
    const Vec3d v = glm::normalize(glm::cross(axis, u));
    for (int k = 0; k < 50; ++k) {
      const double s = random.unit(), angle = 6.283185307179586 * random.unit();
      const double radius = (1 - s) * cone.base_radius + s * cone.apex_radius;
      const Vec3 p(Vec3d(cone.base) + s * axis +
                   radius * (std::cos(angle) * u + std::sin(angle) * v));
      const float slack = 1e-6f;
      ASSERT_TRUE((Aabb{bounds.lo - slack, bounds.hi + slack}).contains(p)) << trial;
      if (cell.contains(p)) {
        ASSERT_TRUE((Aabb{part.lo - slack, part.hi + slack}).contains(p)) << trial;
      }
    }
  }
}

}  // namespace
}  // namespace bspview
