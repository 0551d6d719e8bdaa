#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "app/viewer/quiet_thread.h"
#include "core/base/result.h"

namespace bspview {

/// Turns requests into immutable results on a thread of its own. The latest wish wins: a wish that
/// equals the one before costs nothing, another one stops the work under way. What was published
/// last stays until something newer is there, also when the newer work fails. All member functions
/// belong to one thread, the interface's; none of them waits but the destructor.
template <class Request, class Value>
class Stage {
 public:
  using Clock = std::chrono::steady_clock;
  using Publish = std::function<void(std::shared_ptr<const Value>)>;
  /// Publishes any number of values, each better than the one before; returns when done, or soon
  /// after `stop` is requested.
  using Work = std::function<Result<void>(const Request&, std::stop_token stop, const Publish&)>;

  /// `wake` is called on the stage's thread whenever there is news. Work that has not published
  /// anything yet gets `patience` to do so before a newer wish stops it: a slider that moves all
  /// the time still shows something.
  Stage(Work work, std::function<void()> wake, Clock::duration patience = {})
      : work_(std::move(work)),
        wake_(std::move(wake)),
        patience_(patience),
        thread_([this](std::stop_token end) { serve(end); }) {}

  ~Stage() {
    thread_.request_stop();
    const std::lock_guard lock(mutex_);
    job_stop_.request_stop();
  }

  /// Asks for `request`; nullopt: for nothing, which drops the value, too. Takes over what was
  /// published since the last call.
  void want(const std::optional<Request>& request) {
    const std::lock_guard lock(mutex_);
    if (request != wanted_) replace_wish(request);
    if (ignored_since_ && Clock::now() - *ignored_since_ >= patience_) job_stop_.request_stop();
    shown_ = published_;
    error_ = failure_;
    busy_ = working_ || pending_;
    overdue_ = ignored_since_.has_value();
  }

  const std::shared_ptr<const Value>& value() const { return shown_; }
  /// Why the last wish came to nothing.
  const std::optional<Error>& error() const { return error_; }
  /// The last wish is not yet carried out.
  bool busy() const { return busy_; }
  /// Work that nobody wants any more is still given patience: call want() again soon.
  bool overdue() const { return overdue_; }

 private:
  void replace_wish(const std::optional<Request>& request) {
    wanted_ = request;
    pending_ = request;
    failure_.reset();
    if (!request) published_.reset();
    if (working_ && (job_published_ || !request)) job_stop_.request_stop();
    if (working_ && !ignored_since_) ignored_since_ = Clock::now();
    if (!request) unwanted_job_ = job_;
    news_.notify_one();
  }

  void serve(std::stop_token end) {
    make_thread_quiet();
    while (std::optional<Request> request = next(end)) {
      finish(carry_out(*request));
      wake_();
    }
  }

  Result<void> carry_out(const Request& request) {
    try {
      return work_(request, job_stop_.get_token(),
                   [this](std::shared_ptr<const Value> v) { publish(v); });
    } catch (const std::bad_alloc&) {
      return Error{"there is not enough memory"};
    }
  }

  std::optional<Request> next(std::stop_token end) {
    std::unique_lock lock(mutex_);
    news_.wait(lock, end, [this] { return pending_.has_value(); });
    if (end.stop_requested()) return std::nullopt;
    ++job_;
    job_stop_ = std::stop_source();
    job_published_ = false;
    working_ = true;
    return std::exchange(pending_, std::nullopt);
  }

  void publish(std::shared_ptr<const Value> value) {
    {
      const std::lock_guard lock(mutex_);
      if (job_ == unwanted_job_) return;
      published_ = std::move(value);
      job_published_ = true;
      if (ignored_since_) job_stop_.request_stop();
    }
    wake_();
  }

  void finish(const Result<void>& result) {
    const std::lock_guard lock(mutex_);
    working_ = false;
    const bool wanted = !ignored_since_.has_value();
    ignored_since_.reset();
    if (!result && wanted) failure_ = result.error();
  }

  const Work work_;
  const std::function<void()> wake_;
  const Clock::duration patience_;

  // Of the interface's thread.
  std::shared_ptr<const Value> shown_;
  std::optional<Error> error_;
  bool busy_ = false, overdue_ = false;

  std::mutex mutex_;  // guards all below
  std::condition_variable_any news_;
  std::optional<Request> wanted_, pending_;
  std::shared_ptr<const Value> published_;
  std::optional<Error> failure_;
  std::optional<Clock::time_point> ignored_since_;  // a newer wish than the work under way
  std::uint64_t job_ = 0, unwanted_job_ = 0;        // numbers of jobs, from 1
  bool working_ = false, job_published_ = false;
  std::stop_source job_stop_;
  std::jthread thread_;  // last: starts when all else is there
};

}  // namespace bspview
