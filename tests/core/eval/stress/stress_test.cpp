#include "core/eval/stress/stress.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/scene/spd.h"

namespace bspview::stress {
namespace {

std::vector<Row> run_checks(const Plan& plan, const NamedScene& scene = {},
                            const Subject& subject = default_subject()) {
  auto rows = run(plan, scene, subject);
  EXPECT_TRUE(rows.ok()) << rows.error().message;
  return rows.ok() ? *std::move(rows) : std::vector<Row>{};
}

NamedScene standard_scene(const char* name, int size) {
  auto scene = make_spd(name, size);
  EXPECT_TRUE(scene.ok());
  return {"spd:" + std::string(name) + ":" + std::to_string(size),
          std::make_shared<Scene>(*std::move(scene))};
}

void expect_none_fails(const std::vector<Row>& rows) {
  EXPECT_FALSE(rows.empty());
  for (const Row& row : rows) {
    EXPECT_EQ(row.failures, 0) << to_text(std::span(&row, 1), 1);
    EXPECT_GT(row.trials, 0);
  }
}

/// A subject that never finds anything.
Subject blind_subject() {
  Subject subject = default_subject();
  subject.closest = [](const World&, const Ray&, RayCost&) { return Hit{}; };
  return subject;
}

/// Every check by itself, so that a failure names it.
class EveryCheck : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryCheck, HoldsInDefaultSettings) {
  const auto check = std::ranges::find(checks(), GetParam(), &Check::id);
  const std::int64_t trials = std::clamp<std::int64_t>(check->trials / 1000, 20, 1000);
  expect_none_fails(run_checks({.trials = trials, .ids = {GetParam()}}));
}

TEST_P(EveryCheck, HoldsOnAStandardScene) {
  const auto check = std::ranges::find(checks(), GetParam(), &Check::id);
  if (check->scene_trials == 0) return;
  expect_none_fails(run_checks({.trials = 20, .ids = {GetParam()}}, standard_scene("jacks", 1)));
}

std::vector<std::string> ids() {
  std::vector<std::string> names;
  for (const Check& check : checks()) names.emplace_back(check.id);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Stress, EveryCheck, ::testing::ValuesIn(ids()),
                         [](const auto& test) { return test.param; });

TEST(Stress, AFailingTrialIsFoundAgainByItsNumberAlone) {
  const Plan plan{.seed = 7, .trials = 300, .ids = {"T06"}};
  const Subject blind = blind_subject();
  const auto rows = run_checks(plan, {}, blind);
  ASSERT_EQ(rows.size(), 1u);
  ASSERT_GT(rows[0].failures, 0);
  ASSERT_TRUE(rows[0].first.has_value());
  Plan alone = plan;
  alone.only = rows[0].first->trial;
  const auto again = run_checks(alone, {}, blind);
  ASSERT_EQ(again[0].trials, 1);
  EXPECT_EQ(again[0].first->sentence, rows[0].first->sentence);
  EXPECT_NE(command_of(again[0], 7).find("--check T06 --seed 7 --trial "), std::string::npos);
}

TEST(Stress, TheSameTrialsFailOnAnyNumberOfThreads) {
  Plan plan{.trials = 500, .ids = {"T05", "T06"}};
  const Subject blind = blind_subject();
  plan.threads = 1;
  const auto one = run_checks(plan, {}, blind);
  plan.threads = 3;
  const auto three = run_checks(plan, {}, blind);
  ASSERT_EQ(one.size(), 2u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].failures, three[i].failures);
    EXPECT_EQ(one[i].first->trial, three[i].first->trial);
    EXPECT_EQ(one[i].first->sentence, three[i].first->sentence);
  }
}

TEST(Stress, GroupsAndIdsChooseWhatRuns) {
  const auto rows = run_checks({.trials = 10, .groups = {"garbage"}});
  ASSERT_FALSE(rows.empty());
  for (const Row& row : rows) EXPECT_EQ(row.group, "garbage");
  EXPECT_EQ(planned_trials({.trials = 10, .ids = {"T04", "T18"}}, {}), 20);
  EXPECT_EQ(planned_trials({.only = 5, .ids = {"T04"}}, {}), 1);
}

TEST(Stress, DearChecksMakeFewerTrialsUnlessTheyAreNamed) {
  const auto count = [](std::int64_t trials, const char* group) {
    return planned_trials({.trials = trials, .groups = {group}}, {});
  };
  EXPECT_EQ(count(2000, "anyhit"), 2000);
  EXPECT_EQ(count(2000, "far"), 800);
  EXPECT_EQ(count(2000, "stops"), 1);
  EXPECT_EQ(count(1, "garbage"), 2);  // at least one of each of two checks
  EXPECT_EQ(planned_trials({.trials = 2000, .ids = {"T22"}}, {}), 2000);
  // A million is a full run.
  EXPECT_EQ(planned_trials({.trials = 1'000'000}, {}), planned_trials({}, {}));
}

TEST(Stress, WhatDependsOnNoSceneIsNotRunOnOne) {
  const NamedScene scene = standard_scene("tetra", 1);
  EXPECT_EQ(planned_trials({.trials = 10, .ids = {"T04"}}, scene), 0);
  EXPECT_EQ(planned_trials({.trials = 10, .ids = {"T06"}}, scene), 10);
}

TEST(Stress, NoFailureInNTrialsBoundsTheRateByThreeOverN) {
  EXPECT_DOUBLE_EQ((Row{.trials = 1000}).upper_bound(), 0.003);
  EXPECT_GT((Row{.trials = 1000, .failures = 10}).upper_bound(), 0.01);
  EXPECT_EQ((Row{.trials = 1, .failures = 1}).upper_bound(), 1.0);
}

TEST(Stress, TheReportHoldsEveryRowAndTheFirstFailureWithItsCommand) {
  const std::vector<Row> rows{{.id = "T05", .group = "leaks", .what = "holds", .trials = 30},
                              {.id = "T06",
                               .scene = "spd:tetra",
                               .trials = 9,
                               .failures = 2,
                               .first = Failure{4, "ray 0x1p+0: lost"}}};
  const std::string text = to_text(rows, 3);
  EXPECT_NE(text.find("T05         30         0"), std::string::npos) << text;
  EXPECT_NE(text.find("ray 0x1p+0: lost"), std::string::npos);
  EXPECT_NE(text.find("bspeval stress spd:tetra --check T06 --seed 3 --trial 4"),
            std::string::npos);
  const auto json = nlohmann::json::parse(to_json(rows, 3));
  EXPECT_EQ(json["failures"], 2);
  EXPECT_EQ(json["trials"], 39);
  EXPECT_EQ(json["rows"][0]["upper_bound"], 0.1);
  EXPECT_TRUE(json["rows"][0]["first_failure"].is_null());
  EXPECT_EQ(json["rows"][1]["first_failure"]["trial"], 4);
}

TEST(Stress, StopsWhenAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  const auto rows = run({.ids = {"T04"}}, {}, default_subject(), Watch(stop.get_token()));
  ASSERT_FALSE(rows.ok());
  EXPECT_EQ(rows.error().message, "stopped");
}

}  // namespace
}  // namespace bspview::stress
