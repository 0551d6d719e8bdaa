#include <nlohmann/json.hpp>

#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

using Json = nlohmann::json;
using StressCommand = Bspeval;

TEST_F(StressCommand, PrintsARowForEveryCheckOfTheGroupAsked) {
  const Outcome outcome = run("stress --rays triangles --trials 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* word : {"id", "trials", "failures", "95 % <", "seconds", "T01", "T02", "T03"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(outcome.out.find("T04"), std::string::npos);
}

TEST_F(StressCommand, JsonHasEveryKeyAndTheBound) {
  const Outcome outcome = run("stress --check T01,T18 --trials 30 --seed 5 --json -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["seed"], 5);
  EXPECT_EQ(json["trials"], 60);
  EXPECT_EQ(json["failures"], 0);
  ASSERT_EQ(json["rows"].size(), 2u);
  for (const Json& row : json["rows"]) {
    for (const char* key : {"id", "group", "what", "scene", "trials", "failures", "upper_bound",
                            "seconds", "first_failure"}) {
      EXPECT_TRUE(row.contains(key)) << key;
    }
    EXPECT_DOUBLE_EQ(row["upper_bound"], 0.1);
  }
  EXPECT_TRUE(json["machine"].contains("cpu"));
}

TEST_F(StressCommand, RunsOnTheSceneAskedForAfterItsOwn) {
  write("a.nff", small_scene());
  const Json json = Json::parse(run("stress a.nff --check T16,T18 --trials 5 --json -").out);
  ASSERT_EQ(json["rows"].size(), 3u);
  EXPECT_TRUE(json["rows"][0]["scene"].is_null());
  EXPECT_EQ(json["rows"][2]["id"], "T16");
  EXPECT_EQ(json["rows"][2]["scene"], "a.nff");
}

TEST_F(StressCommand, OneTrialIsRunByItsNumber) {
  const Json json = Json::parse(run("stress --check T01 --seed 7 --trial 48213 --json -").out);
  ASSERT_EQ(json["rows"].size(), 1u);
  EXPECT_EQ(json["rows"][0]["trials"], 1);
  write("a.nff", small_scene());
  const Outcome on_scene = run("stress a.nff --check T16 --trial 3 --json -");
  const Json rows = Json::parse(on_scene.out)["rows"];
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["scene"], "a.nff");
}

TEST_F(StressCommand, NothingToRunIsAnError) {
  write("a.nff", small_scene());
  const Outcome outcome = run("stress a.nff --check T01 --trial 3");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "bspeval: none of the checks asked for runs there\n");
}

}  // namespace
}  // namespace bspview::test
