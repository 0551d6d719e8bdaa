// The test of one ray against one object of each kind. Half of the rays, in no order, are aimed at
// the object, the others anywhere; `hits` is the share that hit.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "core/shape/cone.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

/// From a sphere of radius 4 towards points near the origin.
std::vector<RayQuery> rays_at_origin() {
  test::Random random(1);
  std::vector<RayQuery> rays;
  for (int i = 0; i < 1024; ++i) {
    const Vec3 origin = 4.0f * random.direction();
    const Vec3 target = random.point(random.below(2) == 0 ? 0.25f : 2.0f);
    rays.emplace_back(Ray{origin, target - origin}, 6.0f);
  }
  return rays;
}

template <class Test>
void test_shape(benchmark::State& state, const Test& test) {
  const std::vector<RayQuery> rays = rays_at_origin();
  for (auto _ : state) {
    for (const RayQuery& ray : rays) benchmark::DoNotOptimize(test(ray));
  }
  const auto hits = std::count_if(rays.begin(), rays.end(),
                                  [&](const RayQuery& ray) { return test(ray) != no_hit; });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(rays.size());
}

void shape_sphere(benchmark::State& state) {
  const Sphere sphere;
  test_shape(state, [&](const RayQuery& ray) { return hit_sphere(ray, sphere, Sides::both); });
}
BENCHMARK(shape_sphere)->Unit(benchmark::kMicrosecond);

void shape_cone(benchmark::State& state, float apex_radius) {
  const ConeFrame frame(Cone{{0, 0, -1}, 1.0f, {0, 0, 1}, apex_radius});
  test_shape(state, [&](const RayQuery& ray) { return hit_cone(ray, frame, Sides::both); });
}
BENCHMARK_CAPTURE(shape_cone, cone, 0.25f)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shape_cone, cylinder, 1.0f)->Unit(benchmark::kMicrosecond);

/// Corners on the unit circle around the z axis; every other one is nearer where `is_star`.
std::vector<Vec3> corners_around(int count, float near_radius) {
  std::vector<Vec3> corners;
  for (int i = 0; i < count; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
    const float radius = i % 2 == 0 ? 1.0f : near_radius;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0f);
  }
  return corners;
}

void shape_polygon(benchmark::State& state, int corner_count, float near_radius) {
  const std::vector<Vec3> corners = corners_around(corner_count, near_radius);
  const PolygonPlane plane = polygon_plane(corners);
  test_shape(state,
             [&](const RayQuery& ray) { return hit_polygon(ray, corners, plane, Sides::both); });
}
BENCHMARK_CAPTURE(shape_polygon, quad, 4, 1.0f)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shape_polygon, star_of_16, 16, 0.5f)->Unit(benchmark::kMicrosecond);

void shape_triangle(benchmark::State& state) {
  const std::vector<Vec3> corners = corners_around(3, 1.0f);
  test_shape(state,
             [&](const RayQuery& ray) { return hit_triangle(ray, corners.data(), Sides::both); });
}
BENCHMARK(shape_triangle)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bspview
