#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/counted.h"
#include "core/eval/bench/first_picture.h"
#include "core/eval/lambda.h"
#include "core/eval/machine_json.h"

namespace bspview {
namespace {

/// Seconds of a peer: the tree, the picture, and both.
struct PeerSummary {
  Measured tree, picture, all;
};

PeerSummary summary_of(std::span<const FirstPictureSeconds> repeats) {
  std::vector<double> tree, picture, all;
  for (const FirstPictureSeconds& seconds : repeats) {
    tree.push_back(seconds.tree);
    picture.push_back(seconds.picture);
    all.push_back(seconds.all());
  }
  return {summarise(std::move(tree)), summarise(std::move(picture)), summarise(std::move(all))};
}

}  // namespace

std::string to_text(const FirstPictureReport& report) {
  const FirstPictureParams& params = report.params;
  std::string text = fmt::format(
      "seconds from a scene in memory to its first picture, {} x {} pixels, one sample each\n"
      "median of the repeats +- half the distance of the quartiles; ratio: time of {} over it\n",
      params.side, params.side, report.peers.front().name);
  for (const FirstPicturePeer& peer : report.peers) {
    text += fmt::format("  {:<12} {}\n", peer.name, peer.what);
  }
  for (const FirstPictureTimes& scene : report.scenes) {
    text +=
        fmt::format("\n{}, {}, {}\n  {:<12} {:>9} {:>9} {:>9} {:>9} {:>7}\n", scene.name,
                    counted(scene.objects, "object"), counted(scene.peers.front().size(), "repeat"),
                    "", "tree", "picture", "all", "+-", "ratio");
    for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
      const auto [tree, picture, all] = summary_of(scene.peers[peer]);
      text += fmt::format("  {:<12} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>7.2f}\n",
                          report.peers[peer].name, tree.median, picture.median, all.median,
                          all.spread, first_picture_ratio(scene, peer));
    }
  }
  return text;
}

std::string to_csv(const FirstPictureReport& report) {
  std::string text = "scene,objects,peer,tree_s,picture_s,all_s,all_s_spread,repeats,ratio\n";
  for (const FirstPictureTimes& scene : report.scenes) {
    for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
      const auto [tree, picture, all] = summary_of(scene.peers[peer]);
      text += fmt::format("{},{},{},{},{},{},{},{},{}\n", scene.name, scene.objects,
                          report.peers[peer].name, tree.median, picture.median, all.median,
                          all.spread, all.repeats, first_picture_ratio(scene, peer));
    }
  }
  return text;
}

std::string to_json(const FirstPictureReport& report) {
  using Json = nlohmann::ordered_json;
  Json json{{"parameters", {{"side", report.params.side}, {"repeats", report.params.repeats}}}};
  for (const FirstPicturePeer& peer : report.peers) {
    json["peers"].push_back({{"name", peer.name}, {"what", peer.what}, {"foreign", peer.foreign}});
  }
  for (const FirstPictureTimes& scene : report.scenes) {
    Json peers = Json::array();
    for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
      const auto [tree, picture, all] = summary_of(scene.peers[peer]);
      peers.push_back({{"name", report.peers[peer].name},
                       {"tree", tree.median},
                       {"picture", picture.median},
                       {"all", all.median},
                       {"all_spread", all.spread},
                       {"repeats", all.repeats},
                       {"ratio", first_picture_ratio(scene, peer)}});
    }
    json["scenes"].push_back(
        {{"name", scene.name}, {"objects", scene.objects}, {"peers", std::move(peers)}});
  }
  json["machine"] = machine_json(report.machine);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bspview
