#include "core/eval/error/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/eval/error/log_axis.h"
#include "core/eval/error/plot.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// A run that takes a moment.
const ErrorStudy& small_study() {
  static const ErrorStudy study = [] {
    const std::vector<Scene> scenes{test::random_scene(200, 1), test::random_triangles(200, 2)};
    const ErrorParams params{.rays = 300, .repeats = 3, .seed = 1};
    ErrorStudy small;
    small.rays = *measure_errors(scenes, params);
    SceneImageError& image = small.images.emplace_back();
    image.scene = "<random>";
    for (const char* name : {"uniform", "adaptive"}) {
      ImageErrorCurve& curve = image.curves.emplace_back();
      curve.name = name;
      for (const double samples : {1.0, 4.0, 16.0}) {
        ImageErrorPoint point{.name = "some", .samples_per_pixel = samples};
        point.seconds.median = 0.01 * samples;
        point.rmse = 0.1 / std::sqrt(samples);
        point.rel_mse = 0.01 / samples;
        curve.points.push_back(point);
      }
    }
    return small;
  }();
  return study;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(ErrorReport, EveryConfigurationIsMeasuredOnEveryScene) {
  const ErrorReport& report = small_study().rays;
  EXPECT_EQ(report.strongest_factors.size(), 3u);
  EXPECT_GE(report.configs.size(), 24u);
  for (const SceneErrors& scene : report.scenes) {
    ASSERT_EQ(scene.counts.size(), report.configs.size());
    for (std::size_t i = 0; i < report.configs.size(); ++i) {
      if (!report.configs[i].choice) continue;
      EXPECT_GT(scene.counts[i].ordinary().rays, 300u);
      EXPECT_EQ(scene.seconds[i][0].size(), 3u);
    }
  }
  EXPECT_EQ(report.scenes[0].counts[default_config].ordinary().wrong(), 0u);
}

TEST(ErrorReport, PoolsRunFromTheFastestToTheSlowest) {
  const ErrorPool all = pool_of_all(small_study().rays);
  EXPECT_TRUE(std::ranges::is_sorted(all.configs, {}, &PooledConfig::ns));
  EXPECT_EQ(pool_of_triangles(small_study().rays).scenes, (std::vector<std::size_t>{1}));
}

TEST(ErrorReport, WhatWasNotFoundHasTheBoundOfThree) {
  ErrorCounts counts;
  EXPECT_FALSE(estimate(counts, Metric::wrong_hits));
  counts.hits[0].rays = 1000000;
  EXPECT_EQ(estimate(counts, Metric::wrong_hits)->value, 3.0);
  EXPECT_TRUE(estimate(counts, Metric::wrong_hits)->is_bound);
  counts.hits[0].lost = 5;
  counts.hits[0].phantom = 2;
  EXPECT_EQ(estimate(counts, Metric::wrong_hits)->value, 7.0);
  EXPECT_EQ(format_estimate(Estimate{3.0, true}), "< 3");
  EXPECT_EQ(format_estimate(std::nullopt), "-");
}

TEST(ErrorReport, TextEndsWithTheVerdict) {
  const std::string text = to_text(small_study());
  EXPECT_TRUE(text.ends_with(verdict(small_study()) + "\n"));
  EXPECT_NE(verdict(small_study()).find("default: 0 wrong of "), std::string::npos);
}

TEST(ErrorReport, CsvHasALineForEveryConfigurationAndPool) {
  const std::string csv = to_csv(small_study());
  const std::size_t columns = occurrences(csv.substr(0, csv.find('\n')), ",");
  const std::string own = csv.substr(csv.find("\"all\",\"default\","));
  EXPECT_EQ(occurrences(own.substr(0, own.find('\n')), ","), columns);
  EXPECT_EQ(occurrences(csv, "\"default\""), 4u);  // all, triangles, two scenes
}

TEST(ErrorReport, JsonHoldsCountsTimesFrontsAndImages) {
  const auto json = nlohmann::json::parse(to_json(small_study()));
  EXPECT_EQ(json["configurations"][0]["name"], "fast");
  EXPECT_EQ(json["scenes"][0]["configurations"][1]["seconds"]["primary"].size(), 3u);
  EXPECT_EQ(json["all"]["configurations"].size(), pool_of_all(small_study().rays).configs.size());
  EXPECT_FALSE(json["all"]["fronts"]["wrong_hits"]["knee"].is_null());
  EXPECT_EQ(json["images"][0]["curves"][0]["points"].size(), 3u);
  EXPECT_EQ(json["verdict"], verdict(small_study()));
}

TEST(ErrorReport, ThePageStandsAlone) {
  const std::string html = to_html(small_study());
  EXPECT_EQ(occurrences(html, "<svg"), 10u);  // six metrics, two on triangles, two of the picture
  EXPECT_EQ(occurrences(html, "<svg"), occurrences(html, "</svg>"));
  EXPECT_NE(html.find("&lt;random&gt;"), std::string::npos);
  for (const char* outside : {"<script", "http:", "https:", "<img", "<link", "nan", "inf\""}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
}

TEST(ErrorPlot, OneFarPointDoesNotPressTheOthersTogether) {
  Plot plot;
  for (const double x : {1.0, 1.1, 1.2, 1.3, 50.0}) plot.points.push_back({.x = x, .y = 10.0});
  const std::string svg = draw_plot(plot);
  EXPECT_EQ(occurrences(svg, "<circle"), 4u);
  EXPECT_NE(svg.find("1 more beyond the right edge"), std::string::npos);
}

TEST(ErrorPlot, LabelsThatWouldOverlapAreLeftOut) {
  Plot plot;
  for (int i = 0; i < 40; ++i)
    plot.points.push_back({.x = 1.0 + 1e-4 * i, .y = 10.0, .label = "a label"});
  EXPECT_LT(occurrences(draw_plot(plot), "a label"), 10u);
}

TEST(LogAxis, TicksAreRoundAndInside) {
  for (const auto& [lo, hi] :
       {std::pair(230.0, 410.0), std::pair(1e-9, 1e3), std::pair(0.9, 11.0)}) {
    const LogAxis axis{lo, hi, 0.0, 100.0};
    const std::vector<Tick> ticks = axis.ticks();
    EXPECT_GE(ticks.size(), 2u);
    EXPECT_LE(ticks.size(), 14u);
    for (const Tick& tick : ticks) {
      EXPECT_GE(axis.place(tick.value), -1e-6);
      EXPECT_LE(axis.place(tick.value), 100.0 + 1e-6);
    }
  }
}

}  // namespace
}  // namespace bspview
