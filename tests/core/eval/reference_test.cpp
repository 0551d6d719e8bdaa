#include "core/eval/reference.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "core/eval/exact_sign.h"
#include "tests/support/brute_force.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Scene one_face(std::initializer_list<Vec3> vertices) {
  Scene scene;
  const std::uint32_t material = add_material(scene, {});
  add_face(scene, material, std::vector<Vec3>(vertices));
  return scene;
}

ExactHit first_hit(const Scene& scene, const Ray& ray, Sides sides = Sides::both) {
  return exact_hits(scene, 0, ray, sides)[0];
}

Ray ray_to(Vec3 origin, Vec3 direction) {
  return {.origin = origin, .direction = direction};
}

TEST(ExactHit, TellsTheInsideOfATriangleFromItsBorder) {
  const Scene scene = one_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto at = [&](float x, float y) { return first_hit(scene, ray_to({x, y, 2}, {0, 0, -1})); };
  EXPECT_EQ(at(0.25f, 0.25f), (ExactHit{Meeting::interior, 2.0}));
  EXPECT_EQ(at(0.5f, 0.0f), (ExactHit{Meeting::border, 2.0}));
  EXPECT_EQ(at(0.5f, 0.5f), (ExactHit{Meeting::border, 2.0}));
  EXPECT_EQ(at(1.0f, 0.0f), (ExactHit{Meeting::border, 2.0}));
  EXPECT_EQ(at(0.5f, -0x1p-149f), ExactHit{});
  EXPECT_EQ(at(0.5f, 0x1p-149f).meeting, Meeting::interior);
}

TEST(ExactHit, TellsTheInsideOfAConcavePolygonFromItsBorder) {
  const Scene scene = one_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}});
  const auto at = [&](float x, float y) {
    return first_hit(scene, ray_to({x, y, -1}, {0, 0, 1})).meeting;
  };
  EXPECT_EQ(at(2, 0.5f), Meeting::interior);
  EXPECT_EQ(at(2, 1), Meeting::border);
  EXPECT_EQ(at(2, 1.00001f), Meeting::miss);
  EXPECT_EQ(at(1, 2.5f), Meeting::border);
  EXPECT_EQ(at(3, 0), Meeting::border);
  EXPECT_EQ(at(5, 0), Meeting::miss);
  EXPECT_EQ(at(0.5f, 3), Meeting::interior);
  EXPECT_EQ(at(-1, 4), Meeting::miss);
}

TEST(ExactHit, ATangentOfASphereIsUndecidedAndItsNeighboursAreNot) {
  Scene scene;
  add_sphere(scene, add_material(scene, {}), {{0, 0, 0}, 1.0f});
  const auto at = [&](float x) { return first_hit(scene, ray_to({x, 0, 5}, {0, 0, -1})).meeting; };
  EXPECT_EQ(at(0.9999f), Meeting::interior);
  EXPECT_EQ(at(1.0f), Meeting::undecided);
  EXPECT_EQ(at(1.0001f), Meeting::miss);
}

TEST(ExactHit, ARimOfAConeIsUndecidedAndTheFarWallFollows) {
  Scene scene;
  add_cone(scene, add_material(scene, {}), {{0, 0, 0}, 1.0f, {0, 0, 4}, 1.0f});
  const auto hits = exact_hits(scene, 0, ray_to({-3, 0, 4}, {1, 0, 0}), Sides::both);
  EXPECT_EQ(hits[0], (ExactHit{Meeting::undecided, 2.0}));
  EXPECT_EQ(hits[1], (ExactHit{Meeting::undecided, 4.0}));
  const auto inner = exact_hits(scene, 0, ray_to({-3, 0, 4}, {1, 0, -0.5f}), Sides::both);
  EXPECT_EQ(inner[0], (ExactHit{Meeting::interior, 2.0}));
  EXPECT_EQ(inner[1], ExactHit{});
}

TEST(ExactHit, OneSidedObjectsAreSeenFromTheFront) {
  const Scene face = one_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(first_hit(face, ray_to({0.2f, 0.2f, 1}, {0, 0, -1}), Sides::front).t, 1.0);
  EXPECT_EQ(first_hit(face, ray_to({0.2f, 0.2f, -1}, {0, 0, 1}), Sides::front), ExactHit{});
  Scene inside_out;
  add_sphere(inside_out, add_material(inside_out, {}), {{0, 0, 0}, -1.0f});
  EXPECT_EQ(first_hit(inside_out, ray_to({0, 0, 5}, {0, 0, -1}), Sides::front).t, 6.0);
}

TEST(ExactHit, NothingMeetsARayThatIsNone) {
  const Scene scene = one_face({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(first_hit(scene, ray_to({0, 0, 1}, {0, 0, 0})), ExactHit{});
  EXPECT_EQ(first_hit(scene, ray_to({nan, 0, 1}, {0, 0, -1})), ExactHit{});
}

/// t of a triangle's plane by rational numbers.
Rational plane_distance(const Ray& ray, const Vec3* v) {
  using Vec = Vec3Of<Rational>;
  const Vec a(v[0]), normal = cross(Vec(v[1]) - a, Vec(v[2]) - a);
  return dot(normal, a - Vec(ray.origin)) / dot(normal, Vec(ray.direction));
}

TEST(ExactHit, DistancesOfTrianglesAreRoundedToNearest) {
  test::Random random(7);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scene scene = one_face({random.point(1.0f), random.point(1.0f), random.point(1.0f)});
    const Vec3* v = scene.vertices.data();
    const Vec3 origin = random.point(3.0f);
    const Ray ray = ray_to(origin, 0.4f * v[0] + 0.3f * v[1] + 0.3f * v[2] - origin);
    const ExactHit hit = first_hit(scene, ray);
    if (hit.meeting == Meeting::miss) continue;
    ++hits;
    const Rational exact = plane_distance(ray, scene.vertices.data());
    const Rational off = abs(Rational(hit.t) - exact);
    const double up = std::nextafter(hit.t, 1e300), down = std::nextafter(hit.t, -1e300);
    EXPECT_LE(off, abs(Rational(up) - exact));
    EXPECT_LE(off, abs(Rational(down) - exact));
  }
  EXPECT_GT(hits, 1000);
}

TEST(CertainSign, AgreesWithRationalNumbersNextToTheBorder) {
  test::Random random(11);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 a = random.point(1.0f), b = random.point(1.0f);
    const float s = random.unit();
    const Vec3 point = a + s * (b - a);  // on the edge but for rounding
    const Vec3 origin = random.point(2.0f);
    Scene scene = one_face({a, b, random.point(1.0f)});
    const Ray ray = ray_to(origin, point - origin);
    using Vec = Vec3Of<Rational>;
    const Vec o(ray.origin), d(ray.direction);
    const auto side = [&](Vec3 p, Vec3 q) { return dot(d, cross(Vec(p) - o, Vec(q) - o)).sign(); };
    const Vec3* v = scene.vertices.data();
    const int u = side(v[2], v[1]), w = side(v[1], v[0]), x = side(v[0], v[2]);
    const bool inside = std::min({u, w, x}) >= 0 || std::max({u, w, x}) <= 0;
    const bool border = u == 0 || w == 0 || x == 0;
    const Meeting expected = !inside ? Meeting::miss : border ? Meeting::border : Meeting::interior;
    // In front of the origin or behind, where t > 0 decides.
    const Meeting met = first_hit(scene, {.origin = origin,
                                          .direction = ray.direction,
                                          .t_min = -std::numeric_limits<float>::infinity()})
                            .meeting;
    EXPECT_EQ(met, expected) << i;
  }
}

TEST(Reference, ItsBoxesHideNothing) {
  const Scene scene = test::random_scene(60, 3);
  const Reference reference(scene);
  test::Random random(5);
  for (int i = 0; i < 1500; ++i) {
    const Ray ray = ray_to(random.point(2.0f), random.direction());
    std::size_t met = 0;
    for (std::uint32_t id = 0; id < scene.objects.size(); ++id)
      for (const ExactHit& hit : exact_hits(scene, id, ray, Sides::both))
        met += hit.meeting != Meeting::miss;
    EXPECT_EQ(reference.meetings(ray).size(), met) << i;
  }
}

TEST(Reference, FindsOurAnswersRight) {
  const Scene scene = test::random_scene(400, 9);
  const Reference reference(scene);
  test::Random random(6);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = random.point(2.0f);
    const Ray ray = ray_to(origin, random.point(1.0f) - origin);
    const Hit hit = test::brute_force(scene, ray);
    hits += static_cast<bool>(hit);
    const Judgement judgement = reference.judge(ray, hit.object, hit.t);
    EXPECT_EQ(judgement.verdict, Verdict::right) << i;
    EXPECT_LE(judgement.t_error, 1.0) << i;
    EXPECT_EQ(reference.judge_any(ray, static_cast<bool>(hit)), Verdict::right) << i;
  }
  EXPECT_GT(hits, 700);
}

TEST(Reference, TellsWrongAnswersApart) {
  Scene scene = one_face({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
  add_face(scene, 0, std::vector<Vec3>{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}});
  add_face(scene, 0, std::vector<Vec3>{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}});
  const Reference reference(scene);
  const Ray ray = ray_to({0, 0, 1}, {0, 0, -1});
  EXPECT_EQ(reference.judge(ray, 0, 1.0).verdict, Verdict::right);
  EXPECT_NEAR(reference.judge(ray, 0, 1.0 + 0x1p-22).t_error, 2.0, 1e-9);
  EXPECT_EQ(reference.judge(ray, 1, 2.0).verdict, Verdict::lost);
  EXPECT_EQ(reference.judge(ray, no_index, no_hit).verdict, Verdict::lost);
  EXPECT_EQ(reference.judge(ray, 2, 1.0).verdict, Verdict::phantom);
  EXPECT_EQ(reference.judge(ray, 0, 1.5).verdict, Verdict::phantom);
  EXPECT_EQ(reference.judge_any(ray, false), Verdict::lost);
  EXPECT_EQ(reference.judge_any(ray_to({3, 3, 1}, {0, 0, -1}), true), Verdict::phantom);
}

TEST(Reference, ASharedBorderMustBeHitAndALonelyOneMay) {
  Scene scene = one_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  add_face(scene, 0, std::vector<Vec3>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const Reference reference(scene);
  const Ray shared = ray_to({0.5f, 0.5f, 1}, {0, 0, -1});
  EXPECT_EQ(reference.judge(shared, 0, 1.0).verdict, Verdict::right);
  EXPECT_EQ(reference.judge(shared, 1, 1.0).verdict, Verdict::right);
  EXPECT_EQ(reference.judge(shared, no_index, no_hit).verdict, Verdict::lost);
  const Ray lonely = ray_to({0.5f, 0.0f, 1}, {0, 0, -1});
  EXPECT_EQ(reference.judge(lonely, 0, 1.0).verdict, Verdict::right);
  EXPECT_EQ(reference.judge(lonely, no_index, no_hit).verdict, Verdict::undecided);
}

TEST(Reference, AHitAtTheOriginOfARayIsRight) {
  const Scene scene = one_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  Ray ray = ray_to({0.25f, 0.25f, 0.0f}, {0.5f, 0.25f, 1.0f});
  ray.t_min = -1.0f;
  EXPECT_EQ(Reference(scene).judge(ray, 0, 0.0, SideRule::two_sided).verdict, Verdict::right);
}

}  // namespace
}  // namespace bspview
