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
TunedScene tuned(ObjectKind kind, std::array<double, 3> nanoseconds) {
  TunedScene scene{.trials = {{}}, .trees = {}};
  KindTimes& times = scene.trees.times.kinds.emplace_back();
  times.peers.push_back({.rays = 1, .nanoseconds = {12.0, 12.0}});
  float cost = 1.0f;
  for (const double ns : nanoseconds) {
    Trial& trial = scene.trials.emplace_back(Trial{.what = Trial::What::cost, .kind = kind});
    trial.recipe.test_costs[static_cast<std::size_t>(kind)] = cost;
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
  ASSERT_EQ(tuned.trials.size(), 16u);  // four kinds at three costs
  const TreeRecipe given;
  EXPECT_EQ(tuned.trials[0].recipe, given);
  for (std::size_t i = 0; i < 12; ++i) {
    TreeRecipe one = given;
    one.test_costs[i / 3] = quick().costs[i % 3];
    EXPECT_EQ(tuned.trials[1 + i].recipe, one);
  }
  const int depth = automatic_depth(scene.objects.size());
  EXPECT_EQ(tuned.trials[13].recipe, TreeRecipe{{.max_depth = depth - 2}});
  EXPECT_EQ(tuned.trials[14].recipe, TreeRecipe{{.max_depth = depth_cap}});
  EXPECT_EQ(tuned.trials[15].recipe, TreeRecipe{{.leaf_size = 4}});
  for (std::size_t i = 0; i < tuned.trials.size(); ++i) {
    const TreeFacts& facts = tuned.trees.trees[i];
    EXPECT_GT(facts.bytes, 0u);
    EXPECT_GT(facts.nodes_a_ray, 1.0);
    EXPECT_GT(facts.tests_a_hit, 1.0);
    EXPECT_EQ(gain(tuned, i).repeats, 2);
  }
  EXPECT_DOUBLE_EQ(gain(tuned, 0).median, 1.0);
  EXPECT_EQ(tuned.best_gain.repeats, 6) << "measured anew";
}

TEST(Tune, GainIsTheGeometricMeanOverTheKindsOfRays) {
  TunedScene scene = tuned(ObjectKind::triangle, {3.0, 12.0, 24.0});
  KindTimes& second = scene.trees.times.kinds.emplace_back();
  second.peers = scene.trees.times.kinds.front().peers;
  second.peers[1].nanoseconds = {12.0, 12.0};
  EXPECT_DOUBLE_EQ(gain(scene, 1).median, 2.0);  // 4 and 1
  EXPECT_EQ(best_trial(scene), 1u);
}

TEST(Tune, NothingBetterIsWhatWasGiven) {
  EXPECT_EQ(best_trial(tuned(ObjectKind::triangle, {13.0, 12.5, 12.1})), 0u);
}

TEST(Tune, AKindCostsTheLeastThatIsAboutTheBest) {
  const TuneReport report = report_of({tuned(ObjectKind::triangle, {10.0, 8.02, 8.0})});
  EXPECT_EQ(fitted_cost(report, ObjectKind::triangle), 2.0);
  EXPECT_FALSE(fitted_cost(report, ObjectKind::sphere));
}

TEST(Tune, AKindIsFittedToTheScenesThatHoldIt) {
  const TuneReport report = report_of({tuned(ObjectKind::triangle, {8.0, 10.0, 12.0}),
                                       tuned(ObjectKind::cone, {12.0, 10.0, 8.0}),
                                       tuned(ObjectKind::cone, {11.0, 10.0, 9.0})});
  EXPECT_EQ(fitted_cost(report, ObjectKind::triangle), 1.0f);
  EXPECT_EQ(fitted_cost(report, ObjectKind::cone), 4.0f);
}

TEST(Tune, TheReportNamesTheBestAndWhatItGainedWhenMeasuredAnew) {
  TuneReport report = report_of({tuned(ObjectKind::triangle, {10.0, 6.0, 8.0})});
  report.scenes[0].best_gain = {1.5, 0.25, 6};
  const std::string text = to_text(report);
  EXPECT_NE(text.find("triangles 2          2.000  0.000"), std::string::npos) << text;
  EXPECT_NE(text.find("triangles 2         1.500 +- 0.250"), std::string::npos) << text;
  EXPECT_NE(text.find("triangles 2\n"), std::string::npos) << text;
  EXPECT_NE(text.find("at most 50.0 % slower"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["cost_intersection"]["triangles"], 2.0);
  EXPECT_TRUE(json["cost_intersection"]["cones"].is_null());
  EXPECT_EQ(json["scenes"][0]["best"], "triangles 2");
  EXPECT_EQ(json["scenes"][0]["best_gain"], 1.5);
  EXPECT_EQ(json["scenes"][0]["trials"][2]["gain"], 2.0);
}

TEST(Tune, APolygonCostsSoMuchACorner) {
  const TuneReport report = report_of({tuned(ObjectKind::polygon, {10.0, 6.0, 8.0})});
  EXPECT_NE(to_text(report).find("C_T being 1: polygons 2 a corner\n"), std::string::npos);
}

TEST(Tune, StopsWithAnError) {
  std::stop_source stopper;
  stopper.request_stop();
  const Scene scene = test::random_scene(50, 1);
  EXPECT_FALSE(run_tune(std::span(&scene, 1), quick(), Watch(stopper.get_token())).ok());
}

}  // namespace
}  // namespace bspview
