#include "core/eval/bench/first_picture.h"

#include <algorithm>

#include "core/base/timer.h"
#include "core/eval/lambda.h"
#include "core/render/lazy_tree.h"

namespace bspview {
namespace {

Result<FirstPictureSeconds> time_whole(const Scene& scene, const BuildParams& build,
                                       const RenderParams& picture, std::stop_token stop) {
  const Timer timer;
  const Result<Tree> tree = build_scene_tree(scene, build, stop);
  if (!tree) return tree.error();
  const FastWorld fast({scene, *tree});
  const double built = timer.seconds();
  const auto image = render_image(fast.world(), scene.camera, picture, stop);
  if (!image) return image.error();
  return FirstPictureSeconds{built, timer.seconds() - built};
}

Result<FirstPictureSeconds> time_lazy(const Scene& scene, const BuildParams& build,
                                      const RenderParams& picture, std::stop_token stop) {
  const Timer timer;
  const auto lazy = LazyTree::build(scene, build, stop);
  if (!lazy) return lazy.error();
  const double built = timer.seconds();
  const auto image = render_image((*lazy)->world(), scene.camera, picture, stop);
  if (!image) return image.error();
  return FirstPictureSeconds{built, timer.seconds() - built};
}

FirstPicturePeer whole_tree(BuildParams params, Builder builder) {
  params.builder = builder;
  const std::string name(name_of(builder));
  return {name, "bspview, the whole tree by " + name, false,
          [params](const Scene& scene, const RenderParams& picture, std::stop_token stop) {
            return time_whole(scene, params, picture, std::move(stop));
          }};
}

}  // namespace

std::vector<FirstPicturePeer> own_first_pictures(const BuildParams& params) {
  BuildParams lazy = params;
  lazy.lazy = true;
  const std::string builder(name_of(params.builder));
  return {whole_tree(params, Builder::sah),
          whole_tree(params, Builder::sah_binned),
          {"lazy", "bspview, a tree by " + builder + " that grows where rays go", false,
           [lazy](const Scene& scene, const RenderParams& picture, std::stop_token stop) {
             return time_lazy(scene, lazy, picture, std::move(stop));
           }}};
}

Result<FirstPictureReport> run_first_picture(std::span<const Scene> scenes,
                                             const FirstPictureParams& params, const Watch& watch) {
  FirstPictureReport report{.params = params, .peers = own_first_pictures(params.build)};
  for (FirstPicturePeer& peer : embree_first_pictures()) {
    report.peers.push_back(std::move(peer));
  }
  const RenderParams picture{
      .width = params.side, .height = params.side, .threads = params.build.threads};
  const double share = 1.0 / static_cast<double>(scenes.size() * report.peers.size());
  for (const Scene& scene : scenes) {
    FirstPictureTimes& times = report.scenes.emplace_back();
    times.name = scene.name;
    times.objects = scene.objects.size();
    times.peers.resize(report.peers.size());
    const Timer timer;
    for (int repeat = 0; repeat < params.repeats; ++repeat) {
      if (repeat > 0 && timer.seconds() > params.patience) break;
      for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
        const auto seconds = report.peers[peer].run(scene, picture, watch.stop);
        if (!seconds) return Error{scene.name + ": " + seconds.error().message};
        if (watch.stopped()) return Error{"stopped"};
        times.peers[peer].push_back(*seconds);
        if (repeat == 0) watch.advance(share);
      }
    }
  }
  return report;
}

double first_picture_ratio(const FirstPictureTimes& times, std::size_t peer) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.peers[peer].size(); ++i) {
    ratios.push_back(times.peers[0][i].all() / times.peers[peer][i].all());
  }
  return summarise(std::move(ratios)).median;
}

}  // namespace bspview
