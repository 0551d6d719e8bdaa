#include "core/eval/bench/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/eval/bench/summary.h"
#include "core/scene/triangulate.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

Peer peer(const char* name, Peer::Answers answers, Peer::Width width, bool foreign) {
  Peer peer;
  peer.name = name;
  peer.what = name;
  peer.answers = answers;
  peer.width = width;
  peer.foreign = foreign;
  return peer;
}

SceneTimes scene_of(const char* name, std::vector<double> nanoseconds) {
  SceneTimes scene;
  scene.name = name;
  scene.segments = 8;
  KindTimes& kind = scene.kinds.emplace_back();
  kind.rays = 64;
  for (const double ns : nanoseconds) {
    PeerTimes& times = kind.peers.emplace_back();
    times.rays = 64;
    if (ns > 0.0) times.nanoseconds = {ns, 2.0 * ns, 0.9 * ns};
  }
  return scene;
}

/// Ours, ours in packets, a rival for one ray and two for many, on two scenes.
BenchReport made_up() {
  constexpr auto robust = Peer::Answers::robust;
  BenchReport report;
  report.params.kinds = {BenchKind::primary};
  report.peers = {peer("ours", robust, Peer::Width::one, false),
                  peer("ours <wide>", robust, Peer::Width::many, false),
                  peer("rival", robust, Peer::Width::one, true),
                  peer("rival 8", robust, Peer::Width::many, true),
                  peer("rival stream", robust, Peer::Width::many, true)};
  report.triangles = {scene_of("a", {200, 100, 100, 50, 25}),
                      scene_of("b", {400, 100, 100, 25, 50})};
  report.triangles[0].kinds[0].peers[2].lost = 7;
  return report;
}

TEST(BenchReport, RatiosAreOfSpeedsRepeatByRepeat) {
  const BenchReport report = made_up();
  EXPECT_EQ(baseline(report), 2u);
  EXPECT_DOUBLE_EQ(speed_ratio(report.triangles[0].kinds[0], 0, 2).median, 0.5);
  EXPECT_DOUBLE_EQ(speed_ratio(report.triangles[0].kinds[0], 0, 2).spread, 0.0);
  EXPECT_NEAR(*mean_ratio(report, report.triangles, BenchKind::primary, 0), std::sqrt(0.125), 1e-9);
  EXPECT_FALSE(mean_ratio(report, report.triangles, BenchKind::shadow, 0));
}

TEST(BenchReport, AMeanIsOverAllScenesOrNone) {
  BenchReport report = made_up();
  report.triangles[1].kinds[0].peers[1].nanoseconds.clear();
  EXPECT_FALSE(mean_ratio(report, report.triangles, BenchKind::primary, 1));
  EXPECT_TRUE(mean_ratio(report, report.triangles, BenchKind::primary, 0));
}

TEST(BenchReport, AnAimIsHeldAgainstTheFasterRivalOfEveryScene) {
  const std::vector<Goal> all = goals(made_up());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].key, "primary");
  EXPECT_EQ(all[0].own, "ours <wide>");
  EXPECT_NEAR(all[0].ratio, 0.25, 1e-9);
  EXPECT_NEAR(all[0].worst_ratio, 0.25, 1e-9);
  EXPECT_FALSE(all[0].stretch);
  EXPECT_TRUE(all[1].stretch);
}

TEST(BenchReport, TheVerdictNamesWhatIsFurthestOff) {
  BenchReport report = made_up();
  EXPECT_EQ(verdict(report).rfind("0 of 1 aims are reached; the furthest off is primary", 0), 0u);
  for (SceneTimes& scene : report.triangles) {
    for (double& ns : scene.kinds[0].peers[1].nanoseconds) ns /= 10.0;
  }
  EXPECT_EQ(verdict(report).rfind("1 of 1 aims are reached", 0), 0u);
  EXPECT_NE(verdict(report).find("take bspview"), std::string::npos);
}

TEST(BenchReport, WithoutARivalItSaysHowToGetOne) {
  BenchReport report = made_up();
  for (Peer& one : report.peers) one.foreign = false;
  EXPECT_EQ(baseline(report), 0u);
  EXPECT_NE(to_text(report).find("install libembree-dev"), std::string::npos);
  EXPECT_TRUE(goals(report).empty());
}

TEST(BenchReport, TheFilesHoldEveryFigure) {
  const BenchReport report = made_up();
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["baseline"], "rival");
  EXPECT_EQ(json["triangles"]["scenes"].size(), 2u);
  const auto& times = json["triangles"]["scenes"][0]["kinds"]["primary"]["peers"][2];
  EXPECT_EQ(times["lost"], 7);
  EXPECT_EQ(times["ns_per_ray"], 100.0);
  EXPECT_EQ(times["ns_per_ray_by_repeat"].size(), 3u);
  EXPECT_NEAR(json["goals"]["primary"]["ratio"], 0.25, 1e-9);
  const std::string csv = to_csv(report);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 11);
  EXPECT_NE(csv.find("\"a\",triangles,8,0,primary,\"rival\",64,100.000,"), std::string::npos);
}

TEST(BenchReport, ThePictureEscapesNamesAndHasABarForEachPeer) {
  const std::string svg = to_svg(made_up());
  EXPECT_EQ(svg.rfind("<svg", 0), 0u);
  EXPECT_NE(svg.find("ours &lt;wide&gt;"), std::string::npos);
  std::size_t bars = 0;
  for (std::size_t at = svg.find("<rect"); at != std::string::npos;
       at = svg.find("<rect", at + 1)) {
    ++bars;
  }
  EXPECT_EQ(bars, 1u + 5u);  // and the page
}

}  // namespace
}  // namespace bspview
