// How far T_TT by replay can be trusted: of the binary tree, on spd:balls with one thread, callgrind
// counts the same conditional branches in the walk of the replay as in that of the picture
// (7,350,260), and the replay finds a share of 0.47 (quartiles 0.44 and 0.49) where sampling the
// program counter of the picture finds 0.41 +- 0.02. In wide nodes single rays visit as many leaves
// again, but where a ray has hit something before its last leaf, the replay, which hits nothing,
// looks at cells that the picture no longer did; eye rays go to the known end.
#include <algorithm>

#include "core/base/timer.h"
#include "core/eval/lambda.h"
#include "core/render/accelerator.h"
#include "core/render/record.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

template <class Work>
double seconds_for(const Work& work) {
  const Timer timer;
  work();
  return timer.seconds();
}

/// The runs of one measurement; once a stop is requested they do nothing.
class Experiment {
 public:
  Experiment(const World& world, const Camera& camera, double patience, const Watch& watch)
      : world_(world), camera_(camera), patience_(patience), watch_(watch) {}

  std::vector<double> builds(int repeats) {
    std::vector<double> seconds{world_.tree.build_seconds + seconds_of(world_.accelerator)};
    for (int i = 1; i < repeats && !watch_.stopped(); ++i) {
      const Result<Tree> tree = build_scene_tree(world_.scene, world_.tree.params, watch_.stop);
      if (tree) seconds.push_back(tree->build_seconds + accelerator_seconds(*tree));
      watch_.advance(1.0);
    }
    return seconds;
  }

  double render(const RenderParams& params) {
    return seconds_for([&] { (void)render_image(world_, camera_, params, watch_).ok(); });
  }

  double replay_seconds(const RenderParams& params, std::span<const RecordedRay> rays,
                        Replay what) const {
    return seconds_for([&] { replay(world_, params, rays, what, watch_.stop); });
  }

  /// T_TR and T_TT / T_TR of each repeat.
  struct Replays {
    std::vector<double> render_seconds, shares;
  };
  Replays replays(const RenderParams& params, int repeats) {
    Replays result;
    const auto rays = record_rays(world_, camera_, params, watch_);
    const Timer timer;
    for (int i = 0; i < repeats && rays && !watch_.stopped(); ++i) {
      if (i > 0 && timer.seconds() > patience_) break;
      const double whole = render(params);
      const double walk = replay_seconds(params, *rays, Replay::walk);
      const double enter = replay_seconds(params, *rays, Replay::enter);
      result.render_seconds.push_back(whole);
      result.shares.push_back(whole > 0.0 ? std::max(0.0, walk - enter) / whole : 0.0);
    }
    return result;
  }

 private:
  static double seconds_of(const Accelerator* accelerator) {
    return accelerator == nullptr ? 0.0 : accelerator->build_seconds();
  }
  /// Of making one for `tree`, where the world has one.
  double accelerator_seconds(const Tree& tree) const {
    if (world_.accelerator == nullptr) return 0.0;
    return seconds_of(make_accelerator({world_.scene, tree}).get());
  }

  const World& world_;
  const Camera& camera_;
  const double patience_;
  const Watch& watch_;
};

}  // namespace

RenderParams recorded_picture(const RenderParams& params) {
  RenderParams smaller = params;
  const auto pixels = [&] { return std::int64_t{smaller.width} * smaller.height; };
  while (pixels() > max_recorded_pixels) {
    smaller.width = (smaller.width + 1) / 2;
    smaller.height = (smaller.height + 1) / 2;
  }
  const std::int64_t samples = std::max<std::int64_t>(1, max_recorded_pixels / pixels());
  smaller.samples = static_cast<int>(std::min<std::int64_t>(smaller.samples, samples));
  return smaller;
}

int planned_runs(const RenderParams& params, const LambdaParams& repeats) {
  const int builds = repeats.build_repeats - 1, replays = repeats.replay_repeats;
  if (replays == 0) return builds + repeats.render_repeats;
  const int renders = recorded_picture(params) == params ? std::max(repeats.render_repeats, replays)
                                                         : repeats.render_repeats + replays;
  return builds + 1 + renders;  // 1: the recording
}

Result<Lambda> measure_lambda(const World& world, const Camera& camera, const RenderParams& params,
                              const LambdaParams& repeats, const Watch& watch) {
  Experiment experiment(world, camera, repeats.patience, watch);
  Lambda lambda;
  lambda.t_cb = summarise(experiment.builds(repeats.build_repeats));
  std::vector<double> render_seconds;
  if (repeats.replay_repeats > 0) {
    const RenderParams recorded = recorded_picture(params);
    Experiment::Replays replays = experiment.replays(recorded, repeats.replay_repeats);
    lambda.t_tt_share = summarise(std::move(replays.shares));
    if (recorded == params) render_seconds = std::move(replays.render_seconds);
  }
  while (static_cast<int>(render_seconds.size()) < repeats.render_repeats && !watch.stopped()) {
    render_seconds.push_back(experiment.render(params));
  }
  if (watch.stopped()) return Error{"stopped"};
  lambda.t_tr = summarise(std::move(render_seconds));
  return lambda;
}

}  // namespace bspview
