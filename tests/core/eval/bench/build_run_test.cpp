#include "core/eval/bench/build_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/scene/spd.h"

namespace bspview {
namespace {

TEST(BenchBuild, SizesAreTheNearestToTheWantedNumbersOfObjects) {
  for (const char* name : {"mount", "tetra", "balls", "gears"}) {
    const std::vector<double> wanted{1e5, 1e3, 1e4};
    const std::vector<int> sizes = nearest_sizes(name, wanted);
    ASSERT_EQ(sizes.size(), 3u) << name;
    EXPECT_TRUE(std::ranges::is_sorted(sizes));
    for (int i = 0; i < 3; ++i) {
      const double objects = std::pow(10.0, 3 + i);
      const double off = std::abs(std::log(*count_spd_objects(name, sizes[i]) / objects));
      for (const int step : {-1, 1}) {
        const double next = *count_spd_objects(name, sizes[i] + step);
        EXPECT_LE(off, std::abs(std::log(next / objects))) << name << " " << objects;
      }
    }
  }
}

TEST(BenchBuild, ASizeThatThereIsNoneOfIsLeftOutAndNoneIsThereTwice) {
  EXPECT_TRUE(nearest_sizes("gears", std::vector{4.0}).empty());
  EXPECT_EQ(nearest_sizes("tetra", std::vector{1000.0, 1024.0, 1100.0}), std::vector{5});
}

TEST(BenchBuild, TheExponentOfNLogNIsFound) {
  BuildFamily family;
  for (const std::size_t n : {1000, 10'000, 100'000}) {
    const double work = static_cast<double>(n) * std::log2(static_cast<double>(n));
    BuiltScene& scene = family.sizes.emplace_back();
    scene.objects = n;
    scene.times = {{.peer = 0, .threads = 1, .seconds = {1e-9 * work}},
                   {.peer = 0, .threads = 2, .seconds = {1e-9 * std::pow(work, 1.5)}}};
  }
  EXPECT_NEAR(fit_of(family, 0, 1)->exponent, 1.0, 1e-9);
  EXPECT_NEAR(fit_of(family, 0, 2)->exponent, 1.5, 1e-9);
  EXPECT_NEAR(fit_of(family, 0, 1)->r2, 1.0, 1e-9);
  EXPECT_FALSE(fit_of(family, 0, 4));
  family.sizes.pop_back();
  EXPECT_FALSE(fit_of(family, 0, 1));
}

TEST(BenchBuild, EveryBuilderIsTimedWithEveryNumberOfThreadsAndReported) {
  BuildBenchParams params;
  params.sizes = {100.0, 400.0, 1600.0};
  params.builders = {Builder::mb, Builder::median};
  params.build.threads = 2;
  params.repeats = 2;
  double sum = 0.0;
  Watch watch;
  watch.progress = [&](double more) { sum += more; };
  const auto report = run_build_bench(params, watch);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_NEAR(sum, 1.0, 1e-9);
  EXPECT_EQ(report->threads, (std::vector{1, 2}));
  ASSERT_EQ(report->families.size(), 4u);
  for (const BuildFamily& family : report->families) {
    for (const BuiltScene& scene : family.sizes) {
      ASSERT_EQ(scene.times.size(), 2 * report->peers.size());
      for (const BuildTimes& times : scene.times) {
        EXPECT_GE(times.seconds.size(), 1u);
        EXPECT_GT(times.seconds.front(), 0.0);
        EXPECT_GT(times.bytes, 0u);
        EXPECT_EQ(times.shape.has_value(), !report->peers[times.peer].foreign);
      }
      EXPECT_EQ(scene.times[0].bytes, scene.times[1].bytes);
    }
  }
  const auto json = nlohmann::json::parse(to_json(*report));
  EXPECT_EQ(json["families"][1]["sizes"][1]["objects"], 256);
  EXPECT_EQ(json["families"][1]["fits"].size(), 2 * report->peers.size());
  EXPECT_EQ(json["families"][0]["sizes"][0]["builds"][0]["builder"], "mb");
  EXPECT_EQ(to_csv(*report).rfind("scene,objects,builder,threads,", 0), 0u);
  EXPECT_NE(to_text(*report).find("seconds ~ (N log N)^exponent"), std::string::npos);
  EXPECT_EQ(to_svg(*report).rfind("<svg", 0), 0u);
}

TEST(BenchBuild, WithoutAChoiceEverySahBuilderTakesPart) {
  const auto report = run_build_bench({.sizes = {100.0}, .repeats = 1});
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->peers.front().name, "sah");
  EXPECT_NE(to_text(*report).find("Too few sizes"), std::string::npos);
}

TEST(BenchBuild, AStopEndsIt) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(run_build_bench({}, Watch(stop.get_token())).ok());
}

}  // namespace
}  // namespace bspview
