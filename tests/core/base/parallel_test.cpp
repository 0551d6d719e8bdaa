#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "core/base/timer.h"

namespace bspview {
namespace {

TEST(Parallel, EveryIndexIsVisitedOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> visits(1000);
    with_threads(threads, [&] {
      parallel_for(1000, [&](int i) { ++visits[static_cast<std::size_t>(i)]; });
    });
    for (const auto& count : visits) ASSERT_EQ(count, 1);
  }
}

TEST(Parallel, RangesTogetherAreEveryIndexOnce) {
  for (const std::size_t count : {0u, 1u, 6u, 7u, 8u, 100u}) {
    std::vector<std::atomic<int>> visits(count);
    parallel_ranges(count, 7, [&](std::size_t first, std::size_t last) {
      EXPECT_LT(first, last);
      EXPECT_LE(last - first, 7u);
      for (std::size_t i = first; i < last; ++i) ++visits[i];
    });
    for (const auto& times : visits) ASSERT_EQ(times, 1);
  }
}

TEST(Parallel, MoreThreadsThanCoresWorkAtTheSameTime) {
  const int threads = thread_count(0) + 2;
  std::atomic<int> arrived = 0;
  const Timer patience;
  const auto meet = [&](int) {
    ++arrived;
    while (arrived < threads && patience.seconds() < 30.0) std::this_thread::yield();
  };
  ::testing::internal::CaptureStderr();
  with_threads(threads, [&] { parallel_for(threads, meet); });
  EXPECT_LT(patience.seconds(), 30.0);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

/// Waits for the other work, not for ever: one thread may do both, one after the other.
void wait_for(const std::atomic<bool>& flag) {
  for (int i = 0; i < 1000000 && !flag; ++i) std::this_thread::yield();
}

TEST(Parallel, AnExceptionBesideItDoesNotCutALoopShort) {
  struct Failure {};
  int short_loops = 0;
  for (int run = 0; run < 5; ++run) {
    std::atomic<bool> begun = false, failing = false;
    const auto loops = [&] {
      wait_for(begun);
      for (int i = 0; i < 1000; ++i) {
        std::atomic<int> visited = 0;
        parallel_for(64, [&](int) { ++visited; });
        short_loops += visited != 64;
        if (i == 5) failing = true;
      }
    };
    const auto fail = [&] {
      begun = true;
      wait_for(failing);
      throw Failure{};
    };
    with_threads(2, [&] { EXPECT_THROW(parallel_invoke(loops, fail), Failure); });
  }
  EXPECT_EQ(short_loops, 0);
}

}  // namespace
}  // namespace bspview
