#include <nlohmann/json.hpp>

#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

class ErrorCommand : public Bspeval {
 protected:
  ErrorCommand() { write("s.nff", small_scene()); }
  static constexpr const char* quick = "error s.nff --rays 200 --repeat 1 ";
};

TEST_F(ErrorCommand, WritesATableAPageAndNumbers) {
  const Outcome outcome = run(std::string(quick) + "--images off -o report --json numbers.json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("default: 0 wrong of "), std::string::npos);
  EXPECT_EQ(read("report/error.json"), read("numbers.json"));
  EXPECT_EQ(read("report/error.csv").rfind("scenes,configuration,", 0), 0u);
  EXPECT_EQ(read("report/error.html").rfind("<!DOCTYPE html>", 0), 0u);
}

TEST_F(ErrorCommand, MeasuresPicturesToo) {
  const Outcome outcome = run(std::string(quick) + "--size 8x6 --json -");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["images"].size(), 1u);
  EXPECT_EQ(json["images"][0]["curves"][0]["name"], "uniform");
}

TEST_F(ErrorCommand, MeasuresPicturesAlone) {
  const Outcome outcome = run("error s.nff --repeat 1 --images only --size 8x6 -o report");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("\nPicture of s: 8 x 6 pixels", 0), 0u) << outcome.out;
  EXPECT_EQ(read("report/images.csv").rfind("scene,width,", 0), 0u);
  EXPECT_FALSE(exists("report/error.csv"));
  EXPECT_EQ(nlohmann::json::parse(read("report/error.json")).count("price"), 0u);
}

TEST_F(ErrorCommand, WhatCannotBeDoneIsSaidBeforeTheWork) {
  EXPECT_EQ(run("error missing.nff").exit_code, 1);
  EXPECT_EQ(run("error s.nff --rays 0").exit_code, 2);
  EXPECT_EQ(run("error s.nff --repeat none").exit_code, 2);
  EXPECT_EQ(run("error s.nff --images some").exit_code, 2);
  write("file", "");
  const Outcome outcome = run("error s.nff -o file/folder");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("bspeval: file/folder: cannot be made a folder", 0), 0u);
}

}  // namespace
}  // namespace bspview::test
