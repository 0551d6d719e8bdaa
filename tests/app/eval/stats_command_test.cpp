#include <nlohmann/json.hpp>

#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

using Json = nlohmann::json;

class Stats : public Bspeval {
 protected:
  Json json_of(const std::string& arguments) const {
    const Outcome outcome = run("stats --json - " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out);
  }
};

TEST_F(Stats, JsonHasEveryPublishedKey) {
  const Json json = json_of("spd:tetra:2");
  const std::vector<std::pair<std::string, std::string>> keys{
      {"scene", "name objects triangles polygons patches spheres cones bounds_min bounds_max"},
      {"build", "builder max_depth leaf_size clip threads"},
      {"tree",
       "nodes interior leaves empty_leaves references deepest_leaf bytes expected_cost "
       "leaves_at_depth leaves_with_objects unbuilt_leaves unbuilt_references"},
      {"delta", "N_LS R_ETNLS N_ADL N_AOIAL N_AOIFL R_FVWV N_RPRT N_AT"},
      {"lambda", "T_CB T_TR T_TT_over_T_TR"},
      {"rays",
       "primary reflected refracted shadow all primary_hits secondary_hits shadow_hits "
       "minimal_tests tests nodes_interior nodes_leaf"},
      {"machine", "cpu cores simd compiler version"}};
  for (const auto& [section, names] : keys) {
    ASSERT_TRUE(json.contains(section)) << section;
    std::istringstream words(names);
    for (std::string key; words >> key;) EXPECT_TRUE(json[section].contains(key)) << key;
  }
}

TEST_F(Stats, WhatNoRayWasShotForIsNotDefined) {
  const Json json = json_of("spd:tetra:2");
  EXPECT_TRUE(json["delta"]["N_RPRT"].is_null());
  EXPECT_TRUE(json["delta"]["N_AT"].is_null());
  EXPECT_TRUE(json["lambda"]["T_TR"].is_null());
  EXPECT_TRUE(json["rays"]["all"].is_null());
  EXPECT_TRUE(json["lambda"]["T_CB"].is_number());
}

TEST_F(Stats, TheDerivedComponentFollowsInBothWaysForEveryBuilder) {
  for (const char* builder : {"naive", "median", "median-longest", "object-median", "mb", "sah"}) {
    const Json json = json_of(std::string("spd:jacks --builder ") + builder);
    const Json& delta = json["delta"];
    const double derived = delta["N_AOIAL"], leaves = delta["N_LS"];
    EXPECT_NEAR(derived, double(delta["N_AOIFL"]) * (1.0 - double(delta["R_ETNLS"])),
                1e-9 * derived);
    EXPECT_NEAR(derived, double(delta["N_ADL"]) * double(json["scene"]["objects"]) / leaves,
                1e-9 * derived);
    EXPECT_EQ(json["build"]["builder"], builder);
    EXPECT_EQ(json["tree"]["nodes"], 2 * int(leaves) - 1);
  }
}

TEST_F(Stats, HistogramsAddUpToTheLeaves) {
  const Json tree = json_of("spd:jacks")["tree"];
  std::uint64_t at_depths = 0, of_sizes = 0, references = 0;
  for (const Json& leaves : tree["leaves_at_depth"]) at_depths += std::uint64_t(leaves);
  for (const Json& pair : tree["leaves_with_objects"]) {
    of_sizes += std::uint64_t(pair[1]);
    references += std::uint64_t(pair[0]) * std::uint64_t(pair[1]);
  }
  EXPECT_EQ(at_depths, tree["leaves"]);
  EXPECT_EQ(of_sizes, tree["leaves"]);
  EXPECT_EQ(references, tree["references"]);
}

TEST_F(Stats, OptionsReachTheTree) {
  const Json json =
      json_of("spd:tetra:3 --builder median --max-depth 6 --leaf-size 3 --clip on --threads 1");
  EXPECT_EQ(json["build"]["max_depth"], 6);
  EXPECT_EQ(json["build"]["leaf_size"], 3);
  EXPECT_EQ(json["build"]["clip"], true);
  EXPECT_EQ(json["build"]["threads"], 1);
  EXPECT_LE(json["tree"]["deepest_leaf"], 6);
}

TEST_F(Stats, ASpentMemoryLimitIsSaid) {
  const Json json = json_of("spd:jacks --memory-limit 4K");
  EXPECT_EQ(json["build"]["memory_limit_reached"], true);
  EXPECT_LE(json["tree"]["bytes"], 4 * 1024);
  EXPECT_NE(run("stats spd:jacks --memory-limit 4K").out.find("memory limit of 4"),
            std::string::npos);
}

TEST_F(Stats, TextShowsEveryComponentAndADashForWhatIsNotDefined) {
  const Outcome outcome = run("stats spd:tetra:2");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* word : {"spd:tetra:2", "N_LS", "R_ETNLS", "N_ADL", "(derived)", "N_AOIFL",
                           "R_FVWV", "N_RPRT", "N_AT", "T_CB", "T_TR", "depth", "objects", "#"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(outcome.out.find("nan"), std::string::npos);
}

TEST_F(Stats, JsonInAFileComesWithTheTextOnStdout) {
  const Outcome outcome = run("stats spd:tetra:2 --json a.json");
  EXPECT_NE(outcome.out.find("N_LS"), std::string::npos);
  EXPECT_EQ(Json::parse(read("a.json"))["scene"]["objects"], 16);
}

TEST_F(Stats, ANameThatIsNoUtf8IsWrittenAllTheSame) {
  write("a\xff.nff", small_scene());
  EXPECT_EQ(json_of("a$(printf '\\377').nff")["scene"]["objects"], 2);
}

}  // namespace
}  // namespace bspview::test
