#include "core/eval/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

using Json = nlohmann::json;

Report full_report() {
  const Scene scene = test::random_scene(40, 3);
  Report report(scene);
  report.tree = TreeReport(*build_scene_tree(scene, {}), Traversal::havran);
  RayCounts rays;
  rays.primary = 100;
  rays.reflected = 20;
  rays.primary_hits = 50;
  rays.tests = 75;
  rays.nodes_inner = 500;
  rays.nodes_leaf = 100;
  report.rays = rays;
  report.delta = compute_delta(report.tree->stats, scene.objects.size(), rays);
  report.lambda = Lambda{Measured{0.5, 0.0, 1}, Measured{2.0, 0.1, 5}, Measured{0.25, 0.02, 5}};
  return report;
}

TEST(Report, JsonSaysWhatWasMeasured) {
  const Json json = Json::parse(to_json(full_report()));
  EXPECT_EQ(json["scene"]["objects"], 40);
  EXPECT_EQ(json["build"]["builder"], "sah");
  EXPECT_EQ(json["build"]["traversal"], "havran");
  EXPECT_EQ(json["delta"]["N_RPRT"], 1.5);
  EXPECT_EQ(json["delta"]["N_AT"], 5.0);
  EXPECT_TRUE(json["delta"]["N_LS"].is_number_unsigned());
  EXPECT_EQ(json["lambda"]["T_TR"], 2.0);
  EXPECT_EQ(json["rays"]["all"], 120);
}

TEST(Report, SpreadsComeWithWhatWasRepeated) {
  const Json lambda = Json::parse(to_json(full_report()))["lambda"];
  EXPECT_FALSE(lambda.contains("T_CB_spread"));
  EXPECT_EQ(lambda["T_TR_spread"], 0.1);
  EXPECT_EQ(lambda["T_TT_over_T_TR_spread"], 0.02);
}

TEST(Report, WhatWasNotAskedForKeepsItsKeysWithoutValues) {
  const Json json = Json::parse(to_json(Report(Scene{})));
  const Json full = Json::parse(to_json(full_report()));
  for (const auto& [section, values] : full.items()) {
    for (const auto& [key, value] : values.items()) {
      const bool optional = key.ends_with("_spread") || key == "T_TT_method";
      EXPECT_TRUE(optional || json[section].contains(key)) << key;
    }
  }
  EXPECT_TRUE(json["delta"]["N_LS"].is_null());
  EXPECT_TRUE(json["scene"]["bounds_min"].is_null());
  EXPECT_EQ(json["scene"]["objects"], 0);
}

TEST(Report, FloatsAreWrittenAsTheirOwnShortestNumber) {
  Scene scene;
  add_sphere(scene, add_material(scene, {}), {{0.1f, 0.2f, 0.3f}, 0.0f});
  Report report(scene);
  report.bounds = {{0.1f, -0.2f, 1e-30f}, {1e30f, 16777216.0f, 0.3f}};
  const std::string json = to_json(report);
  EXPECT_NE(json.find("\"bounds_min\":[0.1,-0.2,1e-30]"), std::string::npos) << json;
  EXPECT_NE(json.find("\"bounds_max\":[1e+30,16777216.0,0.3]"), std::string::npos) << json;
}

TEST(Report, TextHasADashForWhatIsNotDefined) {
  Report report(Scene{});
  report.delta = compute_delta(TreeStats{}, 0, RayCounts{});
  const std::string text = to_text(report);
  EXPECT_NE(text.find("traversed nodes per ray                                 -\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("Lambda"), std::string::npos);
}

TEST(Report, TextCountsOneInTheSingular) {
  const Scene scene = test::random_scene(1, 3);
  Report report(scene);
  report.tree = TreeReport(*build_scene_tree(scene, {.builder = Builder::naive}), {});
  report.samples_per_pixel = 1.0;
  const std::string text = to_text(report);
  for (const char* phrase : {" 1 object:", " 1 node:", " 1 leaf,", " 1 reference\n", " 1 sample "}) {
    EXPECT_NE(text.find(phrase), std::string::npos) << phrase << "\n" << text;
  }
}

TEST(Report, TextFitsIntoATerminal) {
  const std::string text = to_text(full_report());
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    EXPECT_LE(end - start, 100u) << text.substr(start, end - start);
    start = end + 1;
  }
}

}  // namespace
}  // namespace bspview
