#include "core/eval/bench/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/scene/spd.h"
#include "core/scene/triangulate.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

BenchParams quick() {
  BenchParams params;
  params.rays = 256;
  params.repeats = 2;
  return params;
}

TEST(BenchRun, EveryPeerAnswersAsTheDefaultDoes) {
  const std::vector<Scene> scenes{test::random_scene(120, 4), *make_spd("balls", 1)};
  const auto report = run_bench(scenes, quick());
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->triangles.size(), 2u);
  ASSERT_EQ(report->shapes.size(), 1u);  // the balls
  for (const auto* const all : {&report->triangles, &report->shapes}) {
    for (const SceneTimes& scene : *all) {
      EXPECT_EQ(scene.kinds.size(), 3u);
      for (const KindTimes& kind : scene.kinds) {
        ASSERT_EQ(kind.peers.size(), report->peers.size());
        for (std::size_t i = 0; i < kind.peers.size(); ++i) {
          const PeerTimes& times = kind.peers[i];
          EXPECT_EQ(times.nanoseconds.size(), 2u) << report->peers[i].name;
          EXPECT_GT(times.nanoseconds.front(), 0.0);
          const bool own = !report->peers[i].foreign;
          const bool exact = own && report->peers[i].answers == Peer::Answers::robust;
          EXPECT_LE(times.wrong(), exact ? 0 : 5 + kind.rays / 50) << report->peers[i].name;
        }
      }
    }
  }
}

TEST(BenchRun, OnlyTheKindsAskedForAreMeasured) {
  BenchParams params = quick();
  params.kinds = {BenchKind::shadow};
  const Scene scene = test::random_scene(50, 4);
  const auto report = run_bench(std::span(&scene, 1), params);
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->triangles[0].kinds.size(), 1u);
  EXPECT_EQ(report->triangles[0].kinds[0].kind, BenchKind::shadow);
}

TEST(BenchRun, ASceneWithoutSuchRaysIsAnError) {
  Scene scene = test::random_scene(50, 4);
  scene.name = "dark";
  scene.lights.clear();
  BenchParams params = quick();
  params.kinds = {BenchKind::shadow};
  const auto report = run_bench(std::span(&scene, 1), params);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().message, "dark: its view has no such rays");
}

TEST(BenchRun, AnEmptySceneIsMeasuredByItsEyeRays) {
  Scene scene;
  scene.name = "empty";
  const auto report = run_bench(std::span(&scene, 1), quick());
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->triangles[0].kinds.size(), 1u);
}

TEST(BenchRun, AStopEndsIt) {
  std::stop_source stop;
  stop.request_stop();
  const Scene scene = test::random_scene(50, 4);
  EXPECT_FALSE(run_bench(std::span(&scene, 1), quick(), Watch(stop.get_token())).ok());
}

TEST(BenchRun, ProgressAddsUpToOne) {
  double sum = 0.0;
  Watch watch;
  watch.progress = [&](double more) { sum += more; };
  const std::vector<Scene> scenes{test::random_scene(50, 4), *make_spd("balls", 1)};
  ASSERT_TRUE(run_bench(scenes, quick(), watch).ok());
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(BenchRun, NamesOfPeersAreDifferentAndTheFirstIsTheRobustDefault) {
  std::vector<Peer> peers = own_peers();
  for (Peer& peer : embree_peers()) peers.push_back(std::move(peer));
  std::set<std::string> names;
  for (const Peer& peer : peers) names.insert(peer.name);
  EXPECT_EQ(names.size(), peers.size());
  EXPECT_EQ(peers.front().answers, Peer::Answers::robust);
  EXPECT_FALSE(peers.front().foreign);
}

TEST(BenchRun, RoundShapesBecomeCoarserWhereTheyAreMany) {
  EXPECT_EQ(bench_segments(*make_spd("balls", 2), 16), 16);
  EXPECT_EQ(bench_segments(*make_spd("balls", 4), 16), least_segments);
}

}  // namespace
}  // namespace bspview
