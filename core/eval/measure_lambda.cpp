#include <algorithm>

#include "core/base/timer.h"
#include "core/eval/lambda.h"
#include "core/render/record.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

template <class Work>
double seconds_of(const Work& work) {
  const Timer timer;
  work();
  return timer.seconds();
}

/// The runs of one measurement; once a stop is requested they do nothing.
class Experiment {
 public:
  Experiment(const World& world, const Camera& camera, const LambdaParams& repeats,
             std::stop_token stop)
      : world_(world), camera_(camera), repeats_(repeats), stop_(std::move(stop)) {}

  void plan(int runs) { planned_ = runs; }
  bool stopped() const { return stop_.stop_requested(); }

  std::vector<double> builds() {
    std::vector<double> seconds{world_.tree.build_seconds};
    for (int i = 1; i < repeats_.build_repeats && !stopped(); ++i) {
      const Result<Tree> tree = build_scene_tree(world_.scene, world_.tree.params, stop_);
      if (tree) seconds.push_back(tree->build_seconds);
      tick();
    }
    return seconds;
  }

  double render(const RenderParams& params) {
    if (stopped()) return 0.0;
    const double seconds =
        seconds_of([&] { (void)render_image(world_, camera_, params, stop_).ok(); });
    tick();
    return seconds;
  }

  /// T_TR and T_TT / T_TR of each repeat.
  struct Replays {
    std::vector<double> render_seconds, shares;
  };
  Replays replays(const RenderParams& params) {
    Replays result;
    const auto rays = record_rays(world_, camera_, params, stop_);
    tick();
    for (int i = 0; i < repeats_.replay_repeats && rays && !stopped(); ++i) {
      const double whole = render(params);
      const double walk = seconds_of([&] { replay(world_, params, *rays, Replay::walk); });
      const double enter = seconds_of([&] { replay(world_, params, *rays, Replay::enter); });
      result.render_seconds.push_back(whole);
      result.shares.push_back(whole > 0.0 ? std::max(0.0, walk - enter) / whole : 0.0);
    }
    return result;
  }

 private:
  void tick() {
    ++done_;
    if (repeats_.progress) repeats_.progress(done_, planned_);
  }

  const World& world_;
  const Camera& camera_;
  const LambdaParams& repeats_;
  std::stop_token stop_;
  int done_ = 0, planned_ = 0;
};

/// How many builds, renders and recordings there will be.
int planned_runs(const LambdaParams& repeats, bool recorded_whole) {
  const int builds = repeats.build_repeats - 1;
  if (repeats.replay_repeats == 0) return builds + repeats.render_repeats;
  const int extra = recorded_whole ? std::max(0, repeats.render_repeats - repeats.replay_repeats)
                                   : repeats.render_repeats;
  return builds + 1 + repeats.replay_repeats + extra;
}

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

Result<Lambda> measure_lambda(const World& world, const Camera& camera, const RenderParams& params,
                              const LambdaParams& repeats, std::stop_token stop) {
  const RenderParams recorded = recorded_picture(params);
  Experiment experiment(world, camera, repeats, stop);
  experiment.plan(planned_runs(repeats, recorded == params));

  Lambda lambda;
  lambda.t_cb = summarise(experiment.builds());
  std::vector<double> render_seconds;
  if (repeats.replay_repeats > 0) {
    Experiment::Replays replays = experiment.replays(recorded);
    lambda.t_tt_share = summarise(std::move(replays.shares));
    if (recorded == params) render_seconds = std::move(replays.render_seconds);
  }
  while (static_cast<int>(render_seconds.size()) < repeats.render_repeats) {
    render_seconds.push_back(experiment.render(params));
  }
  if (experiment.stopped()) return Error{"stopped"};
  lambda.t_tr = summarise(std::move(render_seconds));
  return lambda;
}

}  // namespace bspview
