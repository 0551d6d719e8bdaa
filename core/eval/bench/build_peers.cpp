#include <fmt/format.h>

#include "core/bsp/stats.h"
#include "core/eval/bench/build_peer.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

Result<TimedBuild> build_once(const Scene& scene, const BuildParams& params, std::stop_token stop) {
  const Result<Tree> tree = build_scene_tree(scene, params, std::move(stop));
  if (!tree) return tree.error();
  const TreeStats stats = tree_stats(*tree);
  return TimedBuild{tree->build_seconds, tree->bytes(),
                    TreeShape{stats.deepest_leaf, stats.expected_cost, tree->memory_limit_reached}};
}

}  // namespace

std::vector<BuildPeer> own_builders(const BuildParams& params, std::span<const Builder> builders) {
  std::vector<BuildPeer> peers;
  for (const Builder builder : builders) {
    BuildPeer& peer = peers.emplace_back();
    peer.name = name_of(builder);
    peer.what = fmt::format("bspview, builder {}", peer.name);
    peer.build = [params, builder](const Scene& scene, int threads, std::stop_token stop) {
      BuildParams own = params;
      own.builder = builder;
      own.threads = threads;
      return build_once(scene, own, std::move(stop));
    };
  }
  return peers;
}

}  // namespace bspview
