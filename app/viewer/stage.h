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

  /// Whether the work under way will make `wish` quick to carry out.
  using Serves = std::function<bool(const Request& wish)>;

  /// What else may keep a newer wish from stopping work that has not published anything yet.
  struct Patience {
    Clock::duration since_start = {};  ///< a slider that moves all the time still shows something
    Serves serves = nullptr;           ///< null: none does
  };

  /// `wake` is called on the stage's thread whenever there is news.
  Stage(Work work, std::function<void()> wake, Patience patience = {})
      : work_(std::move(work)),
        wake_(std::move(wake)),
        patience_(std::move(patience)),
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
    drop_due_ = find_drop_due();
    if (drop_due_ && Clock::now() >= *drop_due_) job_stop_.request_stop();
    shown_ = published_;
    error_ = failure_;
    busy_ = working_ || pending_;
  }

  const std::shared_ptr<const Value>& value() const { return shown_; }
  /// Why the last wish came to nothing.
  const std::optional<Error>& error() const { return error_; }
  /// The last wish is not yet carried out.
  bool busy() const { return busy_; }
  /// When to call want() again, at the latest: work that nobody wants any more then ends.
  const std::optional<Clock::time_point>& drop_due() const { return drop_due_; }

 private:
  std::optional<Clock::time_point> find_drop_due() const {
    if (!unwanted_ || job_stop_.stop_requested()) return std::nullopt;
    if (pending_ && patience_.serves && patience_.serves(*pending_)) return std::nullopt;
    return job_start_ + patience_.since_start;
  }

  void replace_wish(const std::optional<Request>& request) {
    wanted_ = request;
    pending_ = request;
    failure_.reset();
    if (!request) published_.reset();
    if (working_ && (job_published_ || !request)) job_stop_.request_stop();
    unwanted_ = working_;
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
    job_start_ = Clock::now();
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
      if (unwanted_) job_stop_.request_stop();
    }
    wake_();
  }

  void finish(const Result<void>& result) {
    const std::lock_guard lock(mutex_);
    working_ = false;
    if (!result && !unwanted_) failure_ = result.error();
    unwanted_ = false;
  }

  const Work work_;
  const std::function<void()> wake_;
  const Patience patience_;

  // Of the interface's thread.
  std::shared_ptr<const Value> shown_;
  std::optional<Error> error_;
  bool busy_ = false;
  std::optional<Clock::time_point> drop_due_;

  std::mutex mutex_;  // guards all below
  std::condition_variable_any news_;
  std::optional<Request> wanted_, pending_;
  std::shared_ptr<const Value> published_;
  std::optional<Error> failure_;
  std::uint64_t job_ = 0, unwanted_job_ = 0;  // numbers of jobs, from 1
  Clock::time_point job_start_;
  bool working_ = false, job_published_ = false;
  bool unwanted_ = false;  // there is a newer wish than the work under way
  std::stop_source job_stop_;
  std::jthread thread_;  // last: starts when all else is there
};

}  // namespace bspview
