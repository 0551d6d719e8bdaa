#include "core/eval/bench/tune.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/scene/spd.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

TuneParams quick() {
  TuneParams params;
  params.bench.rays = 128;
  params.bench.repeats = 2;
  params.costs = {0.5f, 1.0f, 2.0f};
  params.depths = {-2, 99};
  params.leaf_sizes = {4};
  return params;
}

/// A scene where trees of C_I 1, 2 and 4 take so many nanoseconds a ray, the one that was given 12.
TunedScene tuned(std::array<double, object_kind_count> shares, std::array<double, 3> nanoseconds) {
  TunedScene scene{.shares = shares, .trials = {{}}, .trees = {}};
  KindTimes& times = scene.trees.times.kinds.emplace_back();
  times.peers.push_back({.rays = 1, .nanoseconds = {12.0, 12.0}});
  float cost = 1.0f;
  for (const double ns : nanoseconds) {
    scene.trials.push_back({Trial::What::cost, {.cost_intersection = cost}});
    times.peers.push_back({.rays = 1, .nanoseconds = {ns, ns}});
    cost *= 2.0f;
  }
  scene.trees.trees.resize(scene.trials.size());
  return scene;
}

TuneReport report_of(std::vector<TunedScene> scenes) {
  TuneReport report;
  report.params.costs = {1.0f, 2.0f, 4.0f};
  report.scenes = std::move(scenes);
  return report;
}

TEST(Tune, EveryTrialDiffersFromWhatWasGivenInOneThing) {
  const Scene scene = test::random_scene(200, 1);
  const auto report = run_tune(std::span(&scene, 1), quick());
  ASSERT_TRUE(report.ok());
  const TunedScene& tuned = report->scenes.at(0);
  ASSERT_EQ(tuned.trials.size(), 7u);
  EXPECT_EQ(tuned.trials[0].build, BuildParams{});
  EXPECT_EQ(tuned.trials[2].build, BuildParams{.cost_intersection = 1.0f});
  const int depth = automatic_depth(scene.objects.size());
  EXPECT_EQ(tuned.trials[4].build, BuildParams{.max_depth = depth - 2});
  EXPECT_EQ(tuned.trials[5].build, BuildParams{.max_depth = depth_cap});
  EXPECT_EQ(tuned.trials[6].build, BuildParams{.leaf_size = 4});
  for (std::size_t i = 0; i < tuned.trials.size(); ++i) {
    const TreeFacts& facts = tuned.trees.trees[i];
    EXPECT_GT(facts.bytes, 0u);
    EXPECT_GT(facts.nodes_a_ray, 1.0);
    EXPECT_GT(facts.tests_a_hit, 1.0);
    EXPECT_EQ(gain(tuned, i).repeats, 2);
  }
  EXPECT_DOUBLE_EQ(gain(tuned, 0).median, 1.0);
}

TEST(Tune, GainIsTheGeometricMeanOverTheKindsOfRays) {
  TunedScene scene = tuned({1.0}, {3.0, 12.0, 24.0});
  KindTimes& second = scene.trees.times.kinds.emplace_back();
  second.peers = scene.trees.times.kinds.front().peers;
  second.peers[1].nanoseconds = {12.0, 12.0};
  EXPECT_DOUBLE_EQ(gain(scene, 1).median, 2.0);  // 4 and 1
  EXPECT_EQ(best_trial(scene), 1u);
}

TEST(Tune, NothingBetterIsWhatWasGiven) {
  EXPECT_EQ(best_trial(tuned({1.0}, {13.0, 12.5, 12.1})), 0u);
}

TEST(Tune, AKindCostsTheLeastThatIsAboutTheBest) {
  const TuneReport report = report_of({tuned({1.0, 0.0}, {10.0, 8.02, 8.0})});
  EXPECT_EQ(fitted_cost(report, ObjectKind::triangle), 2.0);
  EXPECT_FALSE(fitted_cost(report, ObjectKind::sphere));
}

TEST(Tune, ScenesCountByTheirShareOfTheKind) {
  const TuneReport report =
      report_of({tuned({0.9, 0.1}, {8.0, 10.0, 12.0}), tuned({0.1, 0.9}, {12.0, 10.0, 8.0})});
  EXPECT_EQ(fitted_cost(report, ObjectKind::triangle), 1.0);
  EXPECT_EQ(fitted_cost(report, ObjectKind::polygon), 4.0);
}

TEST(Tune, TheReportNamesTheBestAndWhatItWouldGain) {
  const TuneReport report = report_of({tuned({1.0}, {10.0, 6.0, 8.0})});
  const std::string text = to_text(report);
  EXPECT_NE(text.find("C_I 2        2.000 +- 0.000"), std::string::npos) << text;
  EXPECT_NE(text.find("triangles 2\n"), std::string::npos) << text;
  EXPECT_NE(text.find("at most 100.0 % slower"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["cost_intersection"]["triangles"], 2.0);
  EXPECT_TRUE(json["cost_intersection"]["cones"].is_null());
  EXPECT_EQ(json["scenes"][0]["best"], "C_I 2");
  EXPECT_EQ(json["scenes"][0]["trials"][2]["gain"], 2.0);
}

TEST(Tune, StopsWithAnError) {
  std::stop_source stopper;
  stopper.request_stop();
  const Scene scene = test::random_scene(50, 1);
  EXPECT_FALSE(run_tune(std::span(&scene, 1), quick(), Watch(stopper.get_token())).ok());
}

}  // namespace
}  // namespace bspview
