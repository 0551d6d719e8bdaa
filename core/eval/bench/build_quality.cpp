#include "core/eval/bench/build_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

/// Rays a second over those through the trees of the first builder.
Measured speed(const TreeComparison& scene, std::size_t tree) {
  return time_ratio(scene.times, 0, tree);
}

std::string row(const BuildReport& report, const TreeComparison& scene, std::size_t tree) {
  const TreeFacts& facts = scene.trees[tree];
  const Measured ratio = speed(scene, tree);
  std::string text =
      fmt::format("  {:<14} {:<12} {:>9.2f} {:>8.2f} {:>8.2f} {:>8.1f}",
                  tree == 0 ? scene.times.name : "", report.peers[tree].name, facts.expected_cost,
                  facts.nodes_a_ray, facts.tests_a_hit, 1e-6 * static_cast<double>(facts.bytes));
  for (const KindTimes& kind : scene.times.kinds) {
    text += fmt::format(" {:>9.3f}", 1e3 / summarise(kind.peers[tree].nanoseconds).median);
  }
  return text + fmt::format(" {:>7.3f} {:>6.3f}\n", ratio.median, ratio.spread);
}

/// How far the rays through one builder's trees are behind those through the first one's.
std::string verdict(const BuildReport& report, std::size_t tree) {
  const auto slower = [&](const TreeComparison& a, const TreeComparison& b) {
    return speed(a, tree).median < speed(b, tree).median;
  };
  const TreeComparison& worst = *std::ranges::min_element(report.quality, slower);
  return fmt::format("{}: at least {:.3f} times the rays a second of {} ({}).\n",
                     report.peers[tree].name, speed(worst, tree).median, report.peers[0].name,
                     worst.times.name);
}

}  // namespace

std::string quality_table(const BuildReport& report) {
  if (report.quality.empty()) return "";
  std::string text = fmt::format(
      "\nWhat rays make of the trees: N_AT, N_RPRT and Mrays/s of recorded rays, speed over that "
      "of {}\n  {:<14} {:<12} {:>9} {:>8} {:>8} {:>8}",
      report.peers[0].name, "", "builder", "cost", "N_AT", "N_RPRT", "MB");
  for (const KindTimes& kind : report.quality.front().times.kinds) {
    text += fmt::format(" {:>9}", name_of(kind.kind));
  }
  text += fmt::format(" {:>7} {:>6}\n", "speed", "+-");
  const std::size_t builders = report.quality.front().trees.size();
  for (const TreeComparison& scene : report.quality) {
    for (std::size_t tree = 0; tree < builders; ++tree) text += row(report, scene, tree);
  }
  for (std::size_t tree = 1; tree < builders; ++tree) text += verdict(report, tree);
  return text;
}

Json quality_json(const BuildReport& report) {
  Json scenes = Json::array();
  for (const TreeComparison& scene : report.quality) {
    Json trees = Json::array();
    for (std::size_t tree = 0; tree < scene.trees.size(); ++tree) {
      const TreeFacts& facts = scene.trees[tree];
      Json one{{"builder", report.peers[tree].name},
               {"expected_cost", facts.expected_cost},
               {"N_AT", facts.nodes_a_ray},
               {"N_RPRT", facts.tests_a_hit},
               {"bytes", facts.bytes},
               {"speed", speed(scene, tree).median},
               {"speed_spread", speed(scene, tree).spread}};
      for (const KindTimes& kind : scene.times.kinds) {
        one["ns"][std::string(name_of(kind.kind))] = kind.peers[tree].nanoseconds;
      }
      trees.push_back(std::move(one));
    }
    scenes.push_back({{"scene", scene.times.name}, {"trees", std::move(trees)}});
  }
  return scenes;
}

}  // namespace bspview
