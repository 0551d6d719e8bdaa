#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

class BenchCommand : public Bspeval {
 protected:
  BenchCommand() { write("s.nff", small_scene()); }
  static constexpr const char* quick = "bench s.nff --rays 64 --repeat 1 ";
};

TEST_F(BenchCommand, WritesATableAPictureAndNumbers) {
  const Outcome outcome = run(std::string(quick) + "-o report --json numbers.json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nGeometric mean of the ratios over 1 scene of triangles\n"),
            std::string::npos);
  EXPECT_EQ(read("report/bench.json"), read("numbers.json"));
  EXPECT_EQ(read("report/bench.csv").rfind("scene,shapes,", 0), 0u);
  EXPECT_EQ(read("report/bench.svg").rfind("<svg", 0), 0u);
}

TEST_F(BenchCommand, KindsAreMeasuredInTheirOrderHoweverTheyAreAskedFor) {
  const Outcome outcome = run(std::string(quick) + "--kinds shadow,primary --json -");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& kinds = json["triangles"]["scenes"][0]["kinds"];
  EXPECT_EQ(kinds.size(), 2u);
  EXPECT_TRUE(kinds.contains("primary") && kinds.contains("shadow"));
}

TEST_F(BenchCommand, ScaleMeasuresGrowingScenes) {
  const Outcome outcome =
      run("bench --scale --max-objects 1.1e3 --rays 64 --repeat 1 --kinds primary -o scale");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("tetra, ns per ray at so many objects"), std::string::npos);
  EXPECT_TRUE(exists("scale/scale.csv") && exists("scale/scale.json"));
  EXPECT_EQ(read("scale/scale.svg").rfind("<svg", 0), 0u);
}

TEST_F(BenchCommand, ScaleHasScenesOfItsOwn) {
  EXPECT_EQ(run("bench s.nff --scale").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --max-objects 2000").exit_code, 2);
  EXPECT_EQ(run("bench --scale --max-objects 10").exit_code, 2);
}

TEST_F(BenchCommand, BuildTimesGrowingScenes) {
  const Outcome outcome =
      run("bench --build --builder mb --sizes 100,300,1e3 --threads 1 --repeat 1 -o build");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("seconds ~ (N log N)^exponent"), std::string::npos);
  EXPECT_TRUE(exists("build/build.csv") && exists("build/build.json"));
  EXPECT_EQ(read("build/build.svg").rfind("<svg", 0), 0u);
  const auto json = nlohmann::json::parse(read("build/build.json"));
  EXPECT_EQ(json["builders"][0]["name"], "mb");
  EXPECT_EQ(json["families"].size(), 4u);
}

TEST_F(BenchCommand, BuildHasScenesOfItsOwn) {
  EXPECT_EQ(run("bench s.nff --build").exit_code, 2);
  EXPECT_EQ(run("bench --sizes 100").exit_code, 2);
  EXPECT_EQ(run("bench --build --sizes 0").exit_code, 2);
  EXPECT_EQ(run("bench --build --sizes 1e9").exit_code, 2);
  EXPECT_EQ(run("bench --build --sizes many").exit_code, 2);
  EXPECT_EQ(run("bench --build --scale").exit_code, 2);
  EXPECT_EQ(run("bench --build --rays 5").exit_code, 2);
}

TEST_F(BenchCommand, BuildComparesWhatRaysMakeOfTheTrees) {
  const Outcome outcome =
      run("bench s.nff --build --quality --rays 64 --sizes 100 --threads 1 --repeat 2 -o q");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("sah-binned: at least "), std::string::npos);
  const auto json = nlohmann::json::parse(read("q/build.json"));
  ASSERT_EQ(json["quality"].size(), 1u);
  ASSERT_EQ(json["quality"][0]["trees"].size(), 2u);
  EXPECT_EQ(json["quality"][0]["trees"][1]["builder"], "sah-binned");
  EXPECT_EQ(json["quality"][0]["trees"][0]["speed"], 1.0);
  EXPECT_GT(json["quality"][0]["trees"][1]["N_AT"], 0.0);
}

TEST_F(BenchCommand, QualityIsOfTreesThatAreBuilt) {
  EXPECT_EQ(run("bench s.nff --quality").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --build --quality --builder naive").exit_code, 2);
}

TEST_F(BenchCommand, FirstPicturesAreTimedFromTheSceneOn) {
  const Outcome outcome = run("bench s.nff --first-picture --repeat 2 -o first --json -");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(exists("first/first_picture.csv"));
  EXPECT_EQ(read("first/first_picture.json"), outcome.out);
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& peers = json["scenes"][0]["peers"];
  ASSERT_GE(peers.size(), 3u);
  EXPECT_EQ(peers[0]["name"], "sah");
  EXPECT_EQ(peers[0]["ratio"], 1.0);
  EXPECT_EQ(peers[2]["name"], "lazy");
  for (const auto& peer : peers) EXPECT_EQ(peer["repeats"], 2);
}

TEST_F(BenchCommand, FirstPicturesTakeNoRays) {
  EXPECT_EQ(run("bench s.nff --first-picture --rays 5").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --first-picture --build").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --first-picture --builder naive").exit_code, 2);
}

TEST_F(BenchCommand, PovRayTakesNoRays) {
  EXPECT_EQ(run("bench s.nff --povray --rays 5").exit_code, 2);
  EXPECT_EQ(run("bench --povray --scale").exit_code, 2);
}

TEST_F(BenchCommand, WithoutPovRayThatIsSaid) {
  const Outcome outcome = run("bench s.nff --povray --repeat 1 --json -");
  if (outcome.exit_code == 0) {
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["pictures"].size(), 1u);
  } else {
    EXPECT_EQ(outcome.err, "bspeval: povray: does not run; install povray for --povray\n");
  }
}

TEST_F(BenchCommand, WithoutAPlaceForPovRaysFilesThatIsSaid) {
  ::setenv("TMPDIR", "/missing", 1);
  const Outcome outcome = run("bench s.nff --povray --repeat 1");
  ::unsetenv("TMPDIR");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "bspeval: no temporary folder can be made for POV-Ray's files\n");
}

TEST_F(BenchCommand, WhatCannotBeDoneIsSaidBeforeTheWork) {
  EXPECT_EQ(run("bench missing.nff").exit_code, 1);
  EXPECT_EQ(run("bench s.nff --rays 0").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --kinds sideways").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --traversal havran").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --segments 5").exit_code, 2);
  EXPECT_EQ(run("bench s.nff --segments 2").exit_code, 2);
  write("file", "");
  const Outcome outcome = run("bench s.nff -o file/folder");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("bspeval: file/folder: cannot be made a folder", 0), 0u);
}

}  // namespace
}  // namespace bspview::test
