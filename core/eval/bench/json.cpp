#include <nlohmann/json.hpp>

#include "core/eval/bench/report.h"
#include "core/eval/bench/summary.h"
#include "core/eval/machine_json.h"

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

Json peer_json(const Peer& peer) {
  return {{"name", peer.name},
          {"what", peer.what},
          {"robust", peer.answers == Peer::Answers::robust},
          {"rays_at_a_time", peer.width == Peer::Width::one ? "one" : "many"},
          {"foreign", peer.foreign}};
}

Json times_json(const KindTimes& kind, std::size_t peer, std::size_t base) {
  const PeerTimes& times = kind.peers[peer];
  if (times.nanoseconds.empty()) return nullptr;
  const Measured ns = summarise(times.nanoseconds), ratio = speed_ratio(kind, peer, base);
  return {{"rays", times.rays},
          {"ns_per_ray", ns.median},
          {"ns_per_ray_spread", ns.spread},
          {"ratio", ratio.median},
          {"ratio_spread", ratio.spread},
          {"ns_per_ray_by_repeat", times.nanoseconds},
          {"lost", times.lost},
          {"phantom", times.phantom},
          {"elsewhere", times.elsewhere}};
}

Json scene_json(const SceneTimes& scene, std::size_t base) {
  Json json{{"name", scene.name},
            {"objects", scene.objects.objects},
            {"segments", scene.segments},
            {"kinds", Json::object()}};
  for (const KindTimes& kind : scene.kinds) {
    Json peers = Json::array();
    for (std::size_t i = 0; i < kind.peers.size(); ++i) peers.push_back(times_json(kind, i, base));
    json["kinds"][std::string(name_of(kind.kind))] = {{"rays", kind.rays},
                                                      {"peers", std::move(peers)}};
  }
  return json;
}

Json means_json(const BenchReport& report, std::span<const SceneTimes> scenes) {
  Json json = Json::object();
  for (const BenchKind kind : report.params.kinds) {
    Json& means = json[std::string(name_of(kind))];
    means = Json::array();
    for (std::size_t i = 0; i < report.peers.size(); ++i) {
      const auto mean = mean_ratio(report, scenes, kind, i);
      means.push_back(mean ? Json(*mean) : Json(nullptr));
    }
  }
  return json;
}

Json goal_json(const Goal& goal) {
  return {{"name", goal.name},
          {"own", goal.own},
          {"ratio", goal.ratio},
          {"wanted", goal.wanted},
          {"stretch", goal.stretch},
          {"worst", goal.worst},
          {"worst_ratio", goal.worst_ratio}};
}

}  // namespace

std::string to_json(const BenchReport& report) {
  const BenchParams& params = report.params;
  const Machine& machine = report.machine;
  const std::size_t base = baseline(report);
  Json json{{"verdict", verdict(report)}};
  json["parameters"] = {{"rays", params.rays}, {"repeats", params.repeats}, {"seed", params.seed}};
  for (const Peer& peer : report.peers) json["peers"].push_back(peer_json(peer));
  json["baseline"] = report.peers[base].name;
  json["goals"] = Json::object();
  for (const Goal& goal : goals(report)) json["goals"][goal.key] = goal_json(goal);
  for (const auto& [key, scenes] :
       {std::pair("triangles", &report.triangles), std::pair("shapes", &report.shapes)}) {
    json[key] = {{"mean_ratio", means_json(report, *scenes)}, {"scenes", Json::array()}};
    for (const SceneTimes& scene : *scenes) json[key]["scenes"].push_back(scene_json(scene, base));
  }
  json["machine"] = machine_json(machine);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bspview
