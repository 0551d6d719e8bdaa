#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/counted.h"
#include "core/eval/bench/scale.h"
#include "core/eval/bench/summary.h"
#include "core/eval/machine_json.h"

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

/// Calls visit(kind, peer) for all.
template <class Visit>
void for_each_series(const ScaleReport& report, const Visit& visit) {
  for (const BenchKind kind : report.params.bench.kinds) {
    for (std::size_t i = 0; i < report.peers.size(); ++i) visit(kind, i);
  }
}

std::string series_name(const ScaleReport& report, BenchKind kind, std::size_t peer) {
  return fmt::format("  {:<10} {:<22}", name_of(kind), report.peers[peer].name);
}

std::string family_table(const ScaleReport& report, const ScaleFamily& family) {
  std::string text = fmt::format("\n{}, ns per ray at so many objects\n{:<35}", family.name, "");
  for (const SceneTimes& scene : family.sizes) {
    text += fmt::format(" {:>8}", scene.objects.objects);
  }
  text += "   a doubling  R^2\n";
  for_each_series(report, [&](BenchKind kind, std::size_t peer) {
    text += series_name(report, kind, peer);
    for (const SceneTimes& scene : family.sizes) {
      const KindTimes* const times = find_kind(scene, kind);
      text += times ? fmt::format(" {:>8.1f}", summarise(times->peers[peer].nanoseconds).median)
                    : fmt::format(" {:>8}", "-");
    }
    const auto fit = fit_of(family, kind, peer);
    text += fit ? fmt::format("   {:>+10.1f} {:>4.2f}\n", fit->a_doubling, fit->r2) : "\n";
  });
  return text;
}

double million_rays(const ThreadTimes& times, std::size_t peer) {
  return 1e-6 * summarise(times.rays_a_second[peer]).median;
}

std::string thread_table(const ScaleReport& report) {
  std::string text =
      fmt::format("\n{}, Mrays/s of so many threads together\n{:<35}", report.thread_scene, "");
  std::vector<int> counts;
  for (const ThreadTimes& times : report.threads) {
    if (times.kind == report.threads.front().kind) counts.push_back(times.threads);
  }
  for (const int count : counts) text += fmt::format(" {:>8}", count);
  text += "\n";
  for_each_series(report, [&](BenchKind kind, std::size_t peer) {
    text += series_name(report, kind, peer);
    for (const ThreadTimes& times : report.threads) {
      if (times.kind == kind) text += fmt::format(" {:>8.2f}", million_rays(times, peer));
    }
    text += "\n";
  });
  return text;
}

/// How much more the default takes a ray for a thousand times the objects, over families and kinds.
std::string verdict(const ScaleReport& report) {
  double least = 0.0, most = 0.0;
  int fits = 0;
  for (const ScaleFamily& family : report.families) {
    for (const BenchKind kind : report.params.bench.kinds) {
      const auto fit = fit_of(family, kind, 0);
      if (!fit) continue;
      least = fits == 0 ? fit->a_doubling : std::min(least, fit->a_doubling);
      most = fits == 0 ? fit->a_doubling : std::max(most, fit->a_doubling);
      ++fits;
    }
  }
  if (fits == 0) return "Too few sizes for a slope: let --max-objects be larger.";
  return fmt::format(
      "Twice the objects cost the default {:.0f} to {:.0f} ns a ray: a thousand times as many, "
      "{:.1f} to {:.1f} us.",
      least, most, 0.01 * least, 0.01 * most);
}

Json scene_json(const ScaleReport& report, const SceneTimes& scene) {
  Json json{{"name", scene.name}, {"objects", scene.objects.objects}};
  for (const KindTimes& kind : scene.kinds) {
    Json peers = Json::array();
    for (std::size_t i = 0; i < report.peers.size(); ++i) {
      const Measured ns = summarise(kind.peers[i].nanoseconds);
      peers.push_back({{"ns_per_ray", ns.median},
                       {"ns_per_ray_spread", ns.spread},
                       {"wrong", kind.peers[i].wrong()}});
    }
    json["kinds"][std::string(name_of(kind.kind))] = {{"rays", kind.rays},
                                                      {"peers", std::move(peers)}};
  }
  return json;
}

Json family_json(const ScaleReport& report, const ScaleFamily& family) {
  Json json{{"name", family.name}, {"sizes", Json::array()}, {"fits", Json::object()}};
  for (const SceneTimes& scene : family.sizes) json["sizes"].push_back(scene_json(report, scene));
  for_each_series(report, [&](BenchKind kind, std::size_t peer) {
    const auto fit = fit_of(family, kind, peer);
    json["fits"][std::string(name_of(kind))].push_back(
        fit ? Json{{"ns_at_one", fit->at_one}, {"ns_a_doubling", fit->a_doubling}, {"r2", fit->r2}}
            : Json(nullptr));
  });
  return json;
}

}  // namespace

std::string to_text(const ScaleReport& report) {
  std::string text = fmt::format(
      "about {} rays of every kind a scene, {}; ns: one thread, its processor "
      "time\na doubling: ns more for twice the objects, by least squares\n",
      report.params.bench.rays, counted(report.params.bench.repeats, "interleaved repeat"));
  for (const ScaleFamily& family : report.families) {
    if (!family.sizes.empty()) text += family_table(report, family);
  }
  if (!report.threads.empty()) text += thread_table(report);
  return text + "\n" + verdict(report) + "\n";
}

std::string to_json(const ScaleReport& report) {
  const Machine& machine = report.machine;
  Json json{{"verdict", verdict(report)},
            {"parameters",
             {{"rays", report.params.bench.rays},
              {"repeats", report.params.bench.repeats},
              {"max_objects", report.params.max_objects},
              {"seed", report.params.bench.seed}}}};
  for (const Peer& peer : report.peers) json["peers"].push_back(peer.name);
  for (const ScaleFamily& family : report.families) {
    json["families"].push_back(family_json(report, family));
  }
  json["thread_scene"] = report.thread_scene;
  json["threads"] = Json::array();
  for (const ThreadTimes& times : report.threads) {
    Json rays = Json::array();
    for (std::size_t i = 0; i < report.peers.size(); ++i) {
      const Measured rate = summarise(times.rays_a_second[i]);
      rays.push_back({{"rays_a_second", rate.median}, {"spread", rate.spread}});
    }
    json["threads"].push_back(
        {{"threads", times.threads}, {"kind", name_of(times.kind)}, {"peers", std::move(rays)}});
  }
  json["machine"] = machine_json(machine);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_csv(const ScaleReport& report) {
  std::string csv =
      "scene,objects,threads,kind,peer,ns_per_ray,ns_per_ray_spread,rays_per_second\n";
  const auto name = [&](std::size_t peer) { return report.peers[peer].name; };
  for (const ScaleFamily& family : report.families) {
    for (const SceneTimes& scene : family.sizes) {
      for (const KindTimes& kind : scene.kinds) {
        for (std::size_t i = 0; i < report.peers.size(); ++i) {
          const Measured ns = summarise(kind.peers[i].nanoseconds);
          csv += fmt::format("{},{},1,{},\"{}\",{:.3f},{:.3f},{:.0f}\n", scene.name,
                             scene.objects.objects, name_of(kind.kind), name(i), ns.median,
                             ns.spread, 1e9 / ns.median);
        }
      }
    }
  }
  for (const ThreadTimes& times : report.threads) {
    for (std::size_t i = 0; i < report.peers.size(); ++i) {
      csv += fmt::format("{},,{},{},\"{}\",,,{:.0f}\n", report.thread_scene, times.threads,
                         name_of(times.kind), name(i), 1e6 * million_rays(times, i));
    }
  }
  return csv;
}

}  // namespace bspview
