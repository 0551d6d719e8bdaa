// Tests of triangles in blocks of eight: one leaf holds many, so that little else is done. Rays
// that pass beside all triangles are tested in float alone; rays that go through one of every
// block, the farthest first, have each of these hits settled in double. The difference is the
// settling.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/render/accelerator.h"
#include "core/render/hits.h"
#include "core/render/scene_tree.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

constexpr int block_count = 16, ray_count = 256;

/// Triangles across the z axis, the farthest first; in every block one on the axis and seven beside
/// it.
Scene stacked_triangles() {
  Scene scene;
  scene.materials.emplace_back();
  for (int i = 0; i < block_count * TriangleBlock::width; ++i) {
    const Vec3 place(i % TriangleBlock::width == 0 ? 0.0f : 4.0f, 0.0f, static_cast<float>(-i));
    add_face(scene, 0,
             std::array{place + Vec3(-1, -1, 0), place + Vec3(1, -1, 0), place + Vec3(0, 1, 0)});
  }
  return scene;
}

/// Rays up the z axis through points near (x, 0).
std::vector<Ray> rays_near(float x) {
  test::Random random(1);
  std::vector<Ray> rays;
  for (int i = 0; i < ray_count; ++i) {
    const float u = random.between(-0.1f, 0.1f), v = random.between(-0.1f, 0.1f);
    const Vec3 tilt(random.between(1e-5f, 1e-4f), random.between(1e-5f, 1e-4f), 0.0f);
    rays.push_back({Vec3(x + u, v, -1000.0f), Vec3(0, 0, 1) + tilt});
  }
  return rays;
}
constexpr float through = 0.0f, beside = 2.0f;

/// The triangles in a tree that is one leaf.
class Leaf {
 public:
  Leaf() : tree_(make_tree()), fast_(World{scene_, tree_}) {
    const Accelerator& accelerator = *fast_.world().accelerator;
    const std::uint32_t leaf = accelerator.tree().nodes[0].child[0];
    BSPVIEW_CHECK(accelerator.leaf(leaf).block_count == block_count);
  }
  const World& world() const { return fast_.world(); }

 private:
  Tree make_tree() const {
    auto tree = build_scene_tree(scene_, {.max_depth = 0});
    BSPVIEW_CHECK(tree);
    return std::move(*tree);
  }

  const Scene scene_ = stacked_triangles();
  const Tree tree_;
  const FastWorld fast_;
};

void report(benchmark::State& state, const Leaf& leaf, const std::vector<Ray>& rays) {
  using benchmark::Counter;
  const auto hits = std::count_if(rays.begin(), rays.end(), [&](const Ray& ray) {
    return static_cast<bool>(fast_closest_hit(leaf.world(), ray, SideRule::two_sided));
  });
  state.counters["hits"] = static_cast<double>(hits) / ray_count;
  state.SetItemsProcessed(state.iterations() * ray_count);
  state.counters["time/block"] =
      Counter(ray_count * block_count, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void test_blocks_one_ray(benchmark::State& state, float x) {
  const Leaf leaf;
  const std::vector<Ray> rays = rays_near(x);
  for (auto _ : state) {
    for (const Ray& ray : rays) {
      benchmark::DoNotOptimize(fast_closest_hit(leaf.world(), ray, SideRule::two_sided));
    }
  }
  report(state, leaf, rays);
}
BENCHMARK_CAPTURE(test_blocks_one_ray, beside, beside)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(test_blocks_one_ray, through, through)->Unit(benchmark::kMicrosecond);

void test_blocks_packet(benchmark::State& state, float x) {
  const Leaf leaf;
  const std::vector<Ray> rays = rays_near(x);
  std::vector<Hit> hits(rays.size());
  for (auto _ : state) {
    closest_hits(leaf.world(), rays, SideRule::two_sided, hits);
    benchmark::DoNotOptimize(hits.data());
    benchmark::ClobberMemory();
  }
  report(state, leaf, rays);
  state.SetLabel(packet_instructions());
}
BENCHMARK_CAPTURE(test_blocks_packet, beside, beside)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(test_blocks_packet, through, through)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bspview
