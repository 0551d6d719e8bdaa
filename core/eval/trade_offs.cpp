#include "core/eval/trade_offs.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/eval/error/pareto.h"
#include "core/eval/error/time.h"
#include "core/eval/kernels.h"
#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

constexpr double most_rays = 4096.0;
constexpr int rounds = 9;

RayBatch sample_rays(const Camera& camera, const RenderParams& params) {
  const double pixels = static_cast<double>(params.width) * params.height;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / most_rays))));
  const PrimaryRays eye(camera, params.width, params.height);
  RayBatch batch;
  for (int y = step / 2; y < params.height; y += step)
    for (int x = step / 2; x < params.width; x += step)
      batch.rays.push_back(sample_ray(eye, x, y, Vec2(0.5f)));
  return batch;
}

/// The shape tests that pictures in this arithmetic use.
KernelChoice choice_of(Arithmetic arithmetic, Traversal traversal) {
  switch (arithmetic) {
    case Arithmetic::textbook:
      return {FaceTest::moeller_float, QuadricTest::textbook_float, traversal};
    case Arithmetic::woop:
      return {FaceTest::woop_float, QuadricTest::textbook_float, traversal};
    case Arithmetic::in_double:
      return {FaceTest::moeller_double, QuadricTest::in_double, traversal};
    case Arithmetic::exact:
      break;
  }
  return {.traversal = traversal};
}

/// One way of tracing at work.
struct Way {
  BoundKernel kernel;
  std::vector<double> seconds;  // of every round
};

class Contest {
 public:
  explicit Contest(const JudgedPicture& picture)
      : reference_(picture.reference), batch_(sample_rays(picture.camera, picture.params)) {
    for (std::size_t a = 0; a < arithmetic_names().size(); ++a)
      for (std::size_t t = 0; t < traversal_names().size(); ++t)
        add(picture.world, static_cast<Arithmetic>(a), static_cast<Traversal>(t));
  }

  /// False when it was stopped.
  bool judge_all(std::stop_token stop) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (stop.stop_requested()) return false;
      points_[i].rays = batch_.rays.size();
      points_[i].wrong = count_wrong(ways_[i].kernel);
    }
    return true;
  }

  void time_all() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      ways_[i].seconds.push_back(time_rays(ways_[i].kernel, batch_, 1));
      const auto rays = static_cast<double>(batch_.rays.size());
      points_[i].nanoseconds = 1e9 * median_of(ways_[i].seconds) / rays;
    }
  }

  const std::vector<TradeOffPoint>& points() const { return points_; }
  bool empty() const { return batch_.rays.empty(); }

 private:
  void add(const World& world, Arithmetic arithmetic, Traversal traversal) {
    points_.push_back({arithmetic, traversal});
    ways_.emplace_back();
    ways_.back().kernel.closest = make_kernel(choice_of(arithmetic, traversal)).closest(world);
  }

  std::size_t count_wrong(const BoundKernel& kernel) const {
    std::vector<RayResult> results(batch_.rays.size());
    kernel.closest(batch_.rays, results);
    std::vector<char> wrong(results.size());
    parallel_for(static_cast<int>(results.size()), [&](int i) {
      const auto ray = static_cast<std::size_t>(i);
      const Verdict verdict =
          reference_.judge(batch_.rays[ray], results[ray].object, results[ray].t).verdict;
      wrong[ray] = verdict == Verdict::lost || verdict == Verdict::phantom;
    });
    return static_cast<std::size_t>(std::ranges::count(wrong, 1));
  }

  const Reference& reference_;
  RayBatch batch_;
  std::vector<TradeOffPoint> points_;
  std::vector<Way> ways_;  // index as in points_
};

}  // namespace

double TradeOffPoint::wrong_a_million() const {
  if (rays == 0) return 0.0;
  return 1e6 * (wrong > 0 ? static_cast<double>(wrong) : 3.0) / static_cast<double>(rays);
}

void measure_trade_offs(const JudgedPicture& picture, std::stop_token stop,
                        const std::function<void(const std::vector<TradeOffPoint>&)>& publish) {
  Contest contest(picture);
  bool judged = false;
  with_threads(picture.params.threads,
               [&] { judged = !contest.empty() && contest.judge_all(stop); });
  for (int round = 0; judged && round < rounds && !stop.stop_requested(); ++round) {
    contest.time_all();
    publish(contest.points());
  }
}

}  // namespace bspview
