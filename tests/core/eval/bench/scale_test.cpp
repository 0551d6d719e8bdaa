#include "core/eval/bench/scale.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/scene/spd.h"

namespace bspview {
namespace {

TEST(BenchScale, SizesGrowAtLeastThreefoldUpToTheMost) {
  for (const char* name : {"tetra", "teapot", "balls"}) {
    double last = 0.0;
    const std::vector<int> sizes = scale_sizes(name, 500.0, 1e5);
    EXPECT_GE(sizes.size(), 2u);
    for (const int size : sizes) {
      const double count = *count_spd_objects(name, size);
      EXPECT_GE(count, 500.0);
      EXPECT_LE(count, 1e5);
      EXPECT_GE(count, 3.0 * last);
      last = count;
    }
  }
  EXPECT_TRUE(scale_sizes("tetra", 500.0, 600.0).empty());
}

TEST(BenchScale, ALineOverTheLogarithmIsFound) {
  const std::vector<std::pair<double, double>> points{{1024, 130}, {4096, 150}, {65536, 190}};
  const LogFit fit = fit_log(points);
  EXPECT_NEAR(fit.a_doubling, 10.0, 1e-9);
  EXPECT_NEAR(fit.at_one, 30.0, 1e-9);
  EXPECT_NEAR(fit.r2, 1.0, 1e-9);
}

TEST(BenchScale, AFlatOrASinglePointHasNoSlope) {
  const std::vector<std::pair<double, double>> flat{{2, 5}, {4, 5}, {8, 5}}, one{{2, 5}};
  EXPECT_EQ(fit_log(flat).a_doubling, 0.0);
  EXPECT_EQ(fit_log(one).a_doubling, 0.0);
}

TEST(BenchScale, SmallSizesAndThreadsAreMeasuredAndReported) {
  ScaleParams params;
  params.bench.rays = 128;
  params.bench.repeats = 1;
  params.max_objects = params.thread_objects = 5000.0;
  double sum = 0.0;
  Watch watch;
  watch.progress = [&](double more) { sum += more; };
  const auto report = run_scale(params, watch);
  ASSERT_TRUE(report.ok());
  EXPECT_NEAR(sum, 1.0, 1e-9);
  EXPECT_FALSE(report->peers.front().foreign);
  for (const ThreadTimes& times : report->threads) {
    ASSERT_EQ(times.rays_a_second.size(), report->peers.size());
    EXPECT_GT(times.rays_a_second.front().front(), 0.0);
  }
  const auto json = nlohmann::json::parse(to_json(*report));
  EXPECT_EQ(json["families"].size(), report->families.size());
  EXPECT_EQ(json["families"][0]["sizes"][0]["objects"], 1024);
  EXPECT_EQ(to_csv(*report).rfind("scene,objects,threads,kind,peer,", 0), 0u);
  EXPECT_NE(to_text(*report).find("tetra, ns per ray"), std::string::npos);
}

TEST(BenchScale, AStopEndsIt) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(run_scale({}, Watch(stop.get_token())).ok());
}

}  // namespace
}  // namespace bspview
