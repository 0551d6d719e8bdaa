#include "core/eval/error/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/eval/error/image_tables.h"
#include "core/eval/error/log_axis.h"
#include "core/eval/error/plot.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// Pictures of one method that takes `effort` times as long, and as many samples, as another.
ImageErrorCurve curve(const char* name, double effort) {
  ImageErrorCurve curve{name, {}};
  for (const double samples : {1.0, 4.0, 16.0}) {
    ImageErrorPoint point{.name = "some", .samples_per_pixel = effort * samples};
    point.seconds.median = 0.01 * effort * samples;
    point.rmse = 0.1 / std::sqrt(samples);
    point.rel_mse = 0.01 / samples;
    curve.points.push_back(point);
  }
  return curve;
}

/// A run that takes a moment.
const ErrorStudy& small_study() {
  static const ErrorStudy study = [] {
    const std::vector<Scene> scenes{test::random_scene(200, 1), test::random_triangles(200, 2)};
    const ErrorParams params{.rays = 300, .repeats = 3, .seed = 1};
    ErrorStudy small;
    small.rays = *measure_errors(scenes, params);
    SceneImageError& image = small.images.emplace_back();
    image.scene = "<random>";
    image.curves = {curve("uniform", 1.0), curve("adaptive", 0.75), curve("cut-off 0.01", 2.0)};
    for (ImageErrorPoint& point : image.curves[1].points) point.params.adaptive = 0.01f;
    for (ImageErrorPoint& point : image.curves[2].points) point.params.cutoff = 0.01f;
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
  EXPECT_TRUE(text.ends_with(verdict(small_study()).back() + "\n"));
  EXPECT_EQ(verdict(small_study())[0].rfind("default: 0 wrong of ", 0), 0u);
}

TEST(ErrorReport, CsvHasALineForEveryConfigurationAndPool) {
  const std::string csv = to_csv(small_study().rays);
  const std::size_t columns = occurrences(csv.substr(0, csv.find('\n')), ",");
  const std::string own = csv.substr(csv.find("\"all\",\"default\","));
  EXPECT_EQ(occurrences(own.substr(0, own.find('\n')), ","), columns);
  EXPECT_EQ(occurrences(csv, "\"default\""), 4u);  // all, triangles, two scenes
}

TEST(ErrorReport, SaysSoWhereEmbreeIsNotThere) {
  ErrorStudy study = small_study();
  while (has_foreign(study.rays)) {
    study.rays.configs.pop_back();
    for (SceneErrors& scene : study.rays.scenes) scene.measured.pop_back();
  }
  for (const std::string& text : {to_text(study), to_html(study)}) {
    EXPECT_NE(text.find("libembree-dev was not there"), std::string::npos);
    EXPECT_EQ(text.find("Embree answers"), std::string::npos);
  }
}

TEST(ErrorReport, AdaptiveSamplingIsJudgedByWhatItSavesAtEqualError) {
  const std::string sentence = verdict(small_study())[1];
  EXPECT_NE(sentence.find("<random>: "), std::string::npos);
  EXPECT_NE(sentence.find("saves 25 % of the samples at equal RMSE"), std::string::npos);
  EXPECT_NE(sentence.find("--adaptive 0.01: 25 %"), std::string::npos) << sentence;
}

TEST(ErrorReport, WhatSavesNothingIsNotRecommended) {
  EXPECT_TRUE(verdict(small_study())[2].ends_with(": leave it at 0."));
  ErrorStudy study;
  study.images = small_study().images;
  for (ImageErrorPoint& point : study.images[0].curves[1].points) point.seconds.median *= 2.0;
  EXPECT_TRUE(verdict(study)[0].ends_with("for time, sample uniformly."));
}

TEST(ErrorReport, NothingIsSaidOfPicturesThatCannotBeCompared) {
  ErrorStudy study;
  study.images = small_study().images;
  for (std::size_t i : {1, 2}) {
    for (ImageErrorPoint& point : study.images[0].curves[i].points) point.rmse = 7.0;
  }
  for (const std::string& sentence : verdict(study)) {
    EXPECT_NE(sentence.find("error that was measured"), std::string::npos) << sentence;
  }
  EXPECT_NE(image_tables(study.images[0])[1].rows[0][7], "25 %");
}

TEST(ErrorReport, PicturesHaveATableForEachWayToSample) {
  const auto tables = image_tables(small_study().images[0]);
  ASSERT_EQ(tables.size(), 3u);
  for (const ImageTable& table : tables) {
    EXPECT_EQ(table.rows.size(), 3u) << table.title;
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.heads.size()) << table.title;
  }
  EXPECT_EQ(tables[1].heads[7], "samples saved");
  EXPECT_EQ(tables[1].rows[1][7], "25 %");
}

TEST(ErrorReport, APictureIsALineOfItsCsv) {
  const std::string csv = to_csv(small_study().images);
  EXPECT_EQ(occurrences(csv, "\n"), 10u);
  const std::size_t columns = occurrences(csv.substr(0, csv.find('\n')), ",");
  EXPECT_EQ(occurrences(csv, ","), 10 * columns);
}

TEST(ErrorReport, PicturesAloneMakeAReport) {
  ErrorStudy study;
  study.images = small_study().images;
  EXPECT_EQ(verdict(study).size(), 2u);
  EXPECT_EQ(to_text(study).rfind("\nPicture of <random>", 0), 0u);
  EXPECT_EQ(occurrences(to_html(study), "<svg"), 4u);
  const auto json = nlohmann::json::parse(to_json(study));
  EXPECT_EQ(json.count("price"), 0u);
  EXPECT_EQ(json["images"].size(), 1u);
}

TEST(ErrorReport, JsonHoldsCountsTimesFrontsAndImages) {
  const auto json = nlohmann::json::parse(to_json(small_study()));
  EXPECT_EQ(json["configurations"][0]["name"], "fast");
  EXPECT_EQ(json["scenes"][0]["configurations"][1]["seconds"]["primary"].size(), 3u);
  EXPECT_EQ(json["all"]["configurations"].size(), pool_of_all(small_study().rays).configs.size());
  EXPECT_FALSE(json["all"]["fronts"]["wrong_hits"]["knee"].is_null());
  EXPECT_EQ(json["images"][0]["curves"][0]["points"].size(), 3u);
  EXPECT_EQ(std::string(json["verdict"]).rfind(verdict(small_study())[0], 0), 0u);
}

TEST(ErrorReport, ThePageStandsAlone) {
  const std::string html = to_html(small_study());
  EXPECT_EQ(occurrences(html, "<svg"), 12u);  // six metrics, two on triangles, four of the picture
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

TEST(ErrorPlot, LabelsKeepClearOfLinesAndBars) {
  Plot plot;
  plot.points = {{.x = 1.0, .y = 10.0}, {.x = 2.0, .y = 10.0, .x_spread = 0.5, .label = "beside"}};
  const auto height_of_label = [&] {
    const std::string svg = draw_plot(plot);
    const std::size_t at = svg.find("class=\"label");
    return svg.substr(svg.find(" y=", at), 9);
  };
  const std::string above = height_of_label();
  plot.points[1].x_spread = 0.0;
  EXPECT_NE(height_of_label(), above);
  plot.lines = {{{{1.0, 10.0}, {2.0, 10.0}, {3.0, 10.0}}, "front"}};
  EXPECT_EQ(height_of_label(), above);
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
