#include "core/eval/stress/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/eval/stress/forest.h"

namespace bspview::stress {
namespace {

bool is_among(const std::vector<std::string>& wanted, std::string_view name) {
  return wanted.empty() || std::ranges::find(wanted, name) != wanted.end();
}

/// `full`: of a full run.
std::int64_t trial_count(const Plan& plan, std::int64_t full) {
  if (!plan.trials) return full;
  if (!plan.ids.empty()) return *plan.trials;
  return std::max<std::int64_t>(1, *plan.trials * full / 1'000'000);
}

/// Trials of `check` on `scene`, from the first to behind the last; empty when it is not to run.
struct TrialRange {
  std::int64_t first = 0, end = 0;
  std::int64_t count() const { return end - first; }
};
TrialRange range_of(const Check& check, const Plan& plan, const NamedScene& scene) {
  const std::int64_t full = scene.scene ? check.scene_trials : check.trials;
  if (full == 0 || !is_among(plan.groups, check.group) || !is_among(plan.ids, check.id)) return {};
  if (plan.only) return {*plan.only, *plan.only + 1};
  return {0, trial_count(plan, full)};
}

/// Gathers what trials on several threads found.
class Tally {
 public:
  void add(std::int64_t failures, const std::optional<Failure>& first) {
    const std::lock_guard lock(mutex_);
    failures_ += failures;
    if (first && (!first_ || first->trial < first_->trial)) first_ = first;
  }
  void write_to(Row& row) const {
    row.failures = failures_;
    row.first = first_;
  }

 private:
  std::mutex mutex_;
  std::int64_t failures_ = 0;
  std::optional<Failure> first_;
};

/// The forest of a scene, grown when a check first asks for it.
class SceneForest {
 public:
  explicit SceneForest(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

  Result<SharedForest> get() {
    if (forest_) return forest_;
    auto grown = grow_forest(scene_, every_leaf_size);
    if (grown) forest_ = *grown;
    return grown;
  }

 private:
  std::shared_ptr<const Scene> scene_;
  SharedForest forest_;
};

/// One check with what it runs on.
struct Job {
  const Check& check;
  const Plan& plan;
  const NamedScene& scene;
  SceneForest& forest;
  TrialRange range;
};

void run_block(const Job& job, const Trial& trial, TrialRange block, Tally& tally) {
  std::int64_t failures = 0;
  std::optional<Failure> first;
  for (std::int64_t number = block.first; number < block.end; ++number) {
    Dice dice(job.plan.seed, job.check.id, job.scene.name, number);
    Complaint complaint = trial(dice);
    if (!complaint) continue;
    if (failures++ == 0) first = Failure{number, *std::move(complaint)};
  }
  tally.add(failures, first);
}

void run_trials(const Job& job, const Trial& trial, const Watch& watch, Tally& tally) {
  const std::int64_t size = std::clamp<std::int64_t>(job.range.count() / 256, 1, 1024);
  const auto blocks = static_cast<int>((job.range.count() + size - 1) / size);
  const auto run_one = [&](int i) {
    if (watch.stopped()) return;
    const std::int64_t from = job.range.first + i * size;
    const TrialRange block{from, std::min(from + size, job.range.end)};
    run_block(job, trial, block, tally);
    watch.advance(static_cast<double>(block.count()));
  };
  if (!job.check.serial) return parallel_for(blocks, run_one);
  for (int i = 0; i < blocks; ++i) run_one(i);
}

Result<Row> run_check(const Job& job, const Subject& subject, const Watch& watch) {
  const Timer timer;
  Row row{.id = std::string(job.check.id),
          .group = std::string(job.check.group),
          .what = std::string(job.check.what),
          .scene = job.scene.name,
          .trials = job.range.count()};
  const auto trial = job.check.prepare({.subject = subject,
                                        .scene = job.scene.scene,
                                        .forest = [&] { return job.forest.get(); },
                                        .seed = job.plan.seed,
                                        .last_trial = job.range.end - 1});
  if (!trial) return Error{fmt::format("{}: {}", job.check.id, trial.error().message)};
  Tally tally;
  run_trials(job, *trial, watch, tally);
  tally.write_to(row);
  row.seconds = timer.seconds();
  return row;
}

}  // namespace

double Row::upper_bound() const {
  if (trials == 0) return 1.0;
  const auto n = static_cast<double>(trials), k = static_cast<double>(failures);
  // Poisson: 3 / N without a failure; with failures, their mean and 1.645 deviations, rounded up.
  return std::min(1.0, failures == 0 ? 3.0 / n : (k + 3.0 + 2.0 * std::sqrt(k)) / n);
}

std::int64_t planned_trials(const Plan& plan, const NamedScene& scene) {
  std::int64_t sum = 0;
  for (const Check& check : checks()) sum += range_of(check, plan, scene).count();
  return sum;
}

Result<std::vector<Row>> run(const Plan& plan, const NamedScene& scene, const Subject& subject,
                             const Watch& watch) {
  std::vector<Row> rows;
  std::optional<Error> error;
  SceneForest forest(scene.scene);
  const auto run_all = [&] {
    for (const Check& check : checks()) {
      const TrialRange range = range_of(check, plan, scene);
      if (range.count() <= 0) continue;
      auto row = run_check({check, plan, scene, forest, range}, subject, watch);
      if (watch.stopped()) error = Error{"stopped"};
      if (!row) error = row.error();
      if (error) return;
      rows.push_back(*std::move(row));
    }
  };
  with_threads(plan.threads, run_all);
  if (error) return *error;
  return rows;
}

}  // namespace bspview::stress
