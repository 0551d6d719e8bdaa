#include <fmt/format.h>

#include <algorithm>

#include "core/base/counted.h"
#include "core/eval/bench/report.h"
#include "core/eval/bench/summary.h"

namespace bspview {
namespace {

constexpr const char* no_embree =
    "Embree was not there when this was built: install libembree-dev and build again to have it "
    "measured, too.\n";

std::string scene_title(const SceneTimes& scene) {
  std::string title = fmt::format("\n{}, {} ", scene.name, scene.objects.objects);
  if (scene.segments == 0) {
    return title + fmt::format("objects as they are, {}, {}\n",
                               counted(scene.objects.spheres, "sphere"),
                               counted(scene.objects.cones, "cone"));
  }
  return title + fmt::format("triangles (round shapes in {} segments)\n", scene.segments);
}

std::string kind_titles(const BenchReport& report, std::string_view indent) {
  std::string text = fmt::format("{:<22}", indent);
  for (const BenchKind kind : report.params.kinds) text += fmt::format("  {:<28}", name_of(kind));
  return text + "\n";
}

std::string cells(const KindTimes* times, std::size_t peer, std::size_t base) {
  if (!times || times->peers[peer].nanoseconds.empty()) {
    return fmt::format("  {:>7} {:>6} {:>5} {:>6} ", "-", "-", "-", "-");
  }
  const Measured ratio = speed_ratio(*times, peer, base);
  const double ns = summarise(times->peers[peer].nanoseconds).median;
  return fmt::format("  {:>7.3f} {:>6.2f} {:>5.2f} {:>6} ", 1e3 / ns, ratio.median, ratio.spread,
                     times->peers[peer].wrong());
}

std::string scene_table(const BenchReport& report, const SceneTimes& scene) {
  std::string text = scene_title(scene) + kind_titles(report, "") + fmt::format("{:<22}", "");
  for (std::size_t i = 0; i < report.params.kinds.size(); ++i) {
    text += fmt::format("  {:>7} {:>6} {:>5} {:>6} ", "Mrays/s", "ratio", "+-", "wrong");
  }
  text += "\n";
  for (std::size_t i = 0; i < report.peers.size(); ++i) {
    text += fmt::format("{:<22}", report.peers[i].name);
    for (const BenchKind kind : report.params.kinds) {
      text += cells(find_kind(scene, kind), i, baseline(report));
    }
    text += "\n";
  }
  return text;
}

std::string mean_table(const BenchReport& report, std::span<const SceneTimes> scenes,
                       std::string_view title) {
  if (scenes.empty()) return "";
  std::string text = fmt::format("\nGeometric mean of the ratios over {} {}\n{:<22}",
                                 counted(scenes.size(), "scene"), title, "");
  for (const BenchKind kind : report.params.kinds) text += fmt::format(" {:>10}", name_of(kind));
  text += "\n";
  for (std::size_t i = 0; i < report.peers.size(); ++i) {
    text += fmt::format("{:<22}", report.peers[i].name);
    for (const BenchKind kind : report.params.kinds) {
      const auto mean = mean_ratio(report, scenes, kind, i);
      text += mean ? fmt::format(" {:>10.2f}", *mean) : fmt::format(" {:>10}", "-");
    }
    text += "\n";
  }
  return text;
}

std::string goal_table(const BenchReport& report) {
  std::string text;
  for (const Goal& goal : goals(report)) {
    text += fmt::format("  {:<66} {:>5.2f} of {:.1f}{} ({}; least {:.2f}, {})\n", goal.name,
                        goal.ratio, goal.wanted, goal.stretch ? ", stretch" : "", goal.own,
                        goal.worst_ratio, goal.worst);
  }
  return text.empty() ? "" : "\nWhat is aimed at: ours, robust, over the rival\n" + text;
}

std::string introduction(const BenchReport& report) {
  const std::size_t base = baseline(report);
  return fmt::format(
      "about {} rays of every kind a scene, recorded once; {}, one thread, its "
      "processor time\nratio: speed over that of {}, median of the repeats +- half the distance of "
      "the quartiles\nwrong: rays with another answer than {}\n{}",
      report.params.rays, counted(report.params.repeats, "interleaved repeat"),
      report.peers[base].name, report.peers.front().name, base == 0 ? no_embree : "");
}

}  // namespace

std::string to_text(const BenchReport& report) {
  std::string text = introduction(report);
  for (const SceneTimes& scene : report.triangles) text += scene_table(report, scene);
  for (const SceneTimes& scene : report.shapes) text += scene_table(report, scene);
  text += mean_table(report, report.triangles, "of triangles");
  text += mean_table(report, report.shapes, "of spheres and cones as they are");
  return text + goal_table(report) + "\n" + verdict(report) + "\n";
}

std::string verdict(const BenchReport& report) {
  std::vector<Goal> all = goals(report);
  std::erase_if(all, [](const Goal& goal) { return goal.stretch; });
  if (all.empty()) {
    return "Nothing was there to be compared with: install libembree-dev, build again and repeat.";
  }
  const auto share = [](const Goal& goal) { return goal.ratio / goal.wanted; };
  const Goal& worst = *std::ranges::min_element(all, {}, share);
  const auto met = std::ranges::count_if(all, [&](const Goal& goal) { return share(goal) >= 1.0; });
  const bool all_met = share(worst) >= 1.0;
  return fmt::format(
      "{} of {} aims are reached; {} is {}: {:.2f} of {:.1f}, least {:.2f} on {}: {}.", met,
      all.size(), all_met ? "the nearest to its bound" : "the furthest off", worst.name,
      worst.ratio, worst.wanted, worst.worst_ratio, worst.worst,
      all_met ? "take bspview" : "look there first");
}

}  // namespace bspview
