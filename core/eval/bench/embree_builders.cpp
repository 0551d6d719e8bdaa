#include "core/eval/bench/build_peer.h"

#ifdef BSPVIEW_EMBREE
#include <fmt/format.h>

#include "core/eval/embree_scene.h"
#endif

namespace bspview {

#ifdef BSPVIEW_EMBREE
namespace {

/// In its default mode: in robust mode it makes no spatial splits. It cannot be stopped.
BuildPeer embree_builder(const std::string& quality, const std::string& what, RTCBuildQuality how) {
  BuildPeer peer;
  peer.name = "Embree " + quality;
  peer.what = fmt::format("Embree " RTC_VERSION_STRING ", {} quality: {}; polygons are triangles",
                          quality, what);
  peer.foreign = true;
  peer.build = [how](const Scene& scene, int threads, std::stop_token) -> Result<TimedBuild> {
    const EmbreeScene built(scene, EmbreeMode::standard, {threads, how});
    return TimedBuild{built.build_seconds(), built.bytes(), std::nullopt};
  };
  return peer;
}

}  // namespace

std::vector<BuildPeer> embree_builders() {
  return {embree_builder("medium", "tree of boxes by binned SAH", RTC_BUILD_QUALITY_MEDIUM),
          embree_builder("high", "with spatial splits, too", RTC_BUILD_QUALITY_HIGH)};
}
#else
std::vector<BuildPeer> embree_builders() {
  return {};
}
#endif

}  // namespace bspview
