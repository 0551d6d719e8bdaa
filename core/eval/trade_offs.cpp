#include "core/eval/trade_offs.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/eval/lambda.h"
#include "core/eval/reference.h"
#include "core/render/pixel_grid.h"
#include "core/render/trace.h"

namespace bspview {
namespace {

constexpr double most_rays = 4096.0;
constexpr int rounds = 9;

std::vector<Ray> sample_rays(const Camera& camera, const RenderParams& params) {
  const double pixels = static_cast<double>(params.width) * params.height;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / most_rays))));
  const PrimaryRays eye(camera, params.width, params.height);
  std::vector<Ray> rays;
  for (int y = step / 2; y < params.height; y += step)
    for (int x = step / 2; x < params.width; x += step)
      rays.push_back(sample_ray(eye, x, y, Vec2(0.5f)));
  return rays;
}

class Contest {
 public:
  Contest(const World& world, const Camera& camera, const RenderParams& params)
      : world_(world), rays_(sample_rays(camera, params)), hits_(rays_.size()) {
    for (std::size_t a = 0; a < arithmetic_names().size(); ++a)
      for (std::size_t t = 0; t < traversal_names().size(); ++t)
        points_.push_back({static_cast<Arithmetic>(a), static_cast<Traversal>(t)});
    seconds_.resize(points_.size());
  }

  /// False when it was stopped.
  bool judge_all(std::stop_token stop) {
    const Reference reference(world_.scene);
    for (TradeOffPoint& point : points_) {
      if (stop.stop_requested()) return false;
      trace(point);
      point.rays = rays_.size();
      std::vector<char> wrong(rays_.size());
      parallel_for(static_cast<int>(rays_.size()), [&](int i) {
        const std::size_t ray = static_cast<std::size_t>(i);
        const Hit& hit = hits_[ray];
        const Verdict verdict = reference.judge(rays_[ray], hit.object, hit.t).verdict;
        wrong[ray] = verdict == Verdict::lost || verdict == Verdict::phantom;
      });
      point.wrong = static_cast<std::size_t>(std::ranges::count(wrong, 1));
    }
    return true;
  }

  void time_all() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Timer timer;
      trace(points_[i]);
      seconds_[i].push_back(timer.seconds());
      const double median = summarise(seconds_[i]).median;
      points_[i].nanoseconds = 1e9 * median / static_cast<double>(rays_.size());
    }
  }

  const std::vector<TradeOffPoint>& points() const { return points_; }
  bool empty() const { return rays_.empty(); }

 private:
  void trace(const TradeOffPoint& point) {
    const TraceRules rules{.traversal = point.traversal, .arithmetic = point.arithmetic};
    NoObserver none;
    for (std::size_t i = 0; i < rays_.size(); ++i)
      hits_[i] = trace_closest(world_, rays_[i], rules, none);
  }

  World world_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
  std::vector<TradeOffPoint> points_;
  std::vector<std::vector<double>> seconds_;  // of every round; index as in points_
};

}  // namespace

double TradeOffPoint::wrong_a_million() const {
  if (rays == 0) return 0.0;
  return 1e6 * (wrong > 0 ? static_cast<double>(wrong) : 3.0) / static_cast<double>(rays);
}

void measure_trade_offs(const World& world, const Camera& camera, const RenderParams& params,
                        std::stop_token stop,
                        const std::function<void(const std::vector<TradeOffPoint>&)>& publish) {
  Contest contest(world, camera, params);
  bool judged = false;
  with_threads(params.threads, [&] { judged = !contest.empty() && contest.judge_all(stop); });
  for (int round = 0; judged && round < rounds && !stop.stop_requested(); ++round) {
    contest.time_all();
    publish(contest.points());
  }
}

}  // namespace bspview
