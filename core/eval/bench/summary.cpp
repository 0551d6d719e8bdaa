#include "core/eval/bench/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bspview {
namespace {

/// Which peers a goal is about.
struct Aim {
  const char* key;
  BenchKind kind;
  bool shapes;  ///< on round shapes as they are, else on triangles
  Peer::Width rivals;
  Peer::Answers rival_answers;
  double wanted;
  bool stretch = false;
};

constexpr auto one = Peer::Width::one, many = Peer::Width::many;
constexpr auto robust = Peer::Answers::robust, fast = Peer::Answers::fast;

constexpr std::array<Aim, 9> aims{{
    {"primary", BenchKind::primary, false, many, robust, 1.0},
    {"primary_stretch", BenchKind::primary, false, many, robust, 1.5, true},
    {"shadow", BenchKind::shadow, false, many, robust, 1.0},
    {"shadow_stretch", BenchKind::shadow, false, many, robust, 1.3, true},
    {"scattered", BenchKind::scattered, false, one, robust, 1.0},
    {"scattered_stretch", BenchKind::scattered, false, one, fast, 1.0, true},
    {"shapes_primary", BenchKind::primary, true, one, robust, 2.0},
    {"shapes_shadow", BenchKind::shadow, true, one, robust, 2.0},
    {"shapes_scattered", BenchKind::scattered, true, one, robust, 2.0},
}};

bool took_part(const KindTimes& times, std::size_t peer) {
  return !times.peers[peer].nanoseconds.empty();
}

std::string describe(const Aim& aim) {
  return fmt::format(
      "{}{}, against {} {}", name_of(aim.kind), aim.shapes ? " on spheres and cones" : "",
      aim.rivals == many ? "the better of Embree's 8 rays and stream" : "Embree's one ray",
      aim.rival_answers == robust ? "robust" : "by default");
}

/// The speed of one of our peers over the fastest rival, by scene; empty without rays or rivals.
struct Race {
  std::vector<double> ratios;
  std::vector<std::string> scenes;
};

Race race(const BenchReport& report, const Aim& aim, std::size_t own) {
  Race result;
  for (const SceneTimes& scene : aim.shapes ? report.shapes : report.triangles) {
    const KindTimes* const times = find_kind(scene, aim.kind);
    if (!times || !took_part(*times, own)) continue;
    std::optional<double> least;
    for (std::size_t i = 0; i < report.peers.size(); ++i) {
      const Peer& rival = report.peers[i];
      const bool counts = rival.foreign && rival.width == aim.rivals &&
                          rival.answers == aim.rival_answers && took_part(*times, i);
      if (!counts) continue;
      const double ratio = speed_ratio(*times, own, i).median;
      least = std::min(least.value_or(ratio), ratio);
    }
    if (!least) continue;
    result.ratios.push_back(*least);
    result.scenes.push_back(scene.name);
  }
  return result;
}

double geometric_mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

std::optional<Goal> reach(const BenchReport& report, const Aim& aim) {
  Goal goal{.name = describe(aim), .key = aim.key, .wanted = aim.wanted, .stretch = aim.stretch};
  std::size_t most_scenes = 0;
  for (std::size_t i = 0; i < report.peers.size(); ++i) {
    if (report.peers[i].foreign || report.peers[i].answers != robust) continue;
    const Race all = race(report, aim, i);
    if (all.ratios.empty() || all.ratios.size() < most_scenes) continue;
    const double ratio = geometric_mean(all.ratios);
    if (all.ratios.size() == most_scenes && ratio <= goal.ratio) continue;
    most_scenes = all.ratios.size();
    goal.own = report.peers[i].name;
    goal.ratio = ratio;
    const auto worst = std::ranges::min_element(all.ratios);
    goal.worst = all.scenes[static_cast<std::size_t>(worst - all.ratios.begin())];
    goal.worst_ratio = *worst;
  }
  return goal.own.empty() ? std::nullopt : std::optional(goal);
}

}  // namespace

std::size_t baseline(const BenchReport& report) {
  const auto found = std::ranges::find_if(report.peers, [](const Peer& peer) {
    return peer.foreign && peer.answers == robust && peer.width == one;
  });
  return found == report.peers.end() ? 0 : static_cast<std::size_t>(found - report.peers.begin());
}

Measured speed_ratio(const KindTimes& times, std::size_t peer, std::size_t base) {
  const auto &own = times.peers[peer].nanoseconds, &other = times.peers[base].nanoseconds;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(own.size(), other.size()); ++i) {
    ratios.push_back(other[i] / own[i]);
  }
  return summarise(std::move(ratios));
}

const KindTimes* find_kind(const SceneTimes& scene, BenchKind kind) {
  const auto found = std::ranges::find(scene.kinds, kind, &KindTimes::kind);
  return found == scene.kinds.end() ? nullptr : &*found;
}

std::optional<double> mean_ratio(const BenchReport& report, std::span<const SceneTimes> scenes,
                                 BenchKind kind, std::size_t peer) {
  const std::size_t base = baseline(report);
  std::vector<double> ratios;
  for (const SceneTimes& scene : scenes) {
    const KindTimes* const times = find_kind(scene, kind);
    if (!times) continue;
    if (!took_part(*times, peer) || !took_part(*times, base)) return std::nullopt;
    ratios.push_back(speed_ratio(*times, peer, base).median);
  }
  return ratios.empty() ? std::nullopt : std::optional(geometric_mean(ratios));
}

std::vector<Goal> goals(const BenchReport& report) {
  std::vector<Goal> all;
  for (const Aim& aim : aims) {
    if (auto goal = reach(report, aim)) all.push_back(*std::move(goal));
  }
  return all;
}

}  // namespace bspview
