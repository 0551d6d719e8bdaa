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

}  // namespace
}  // namespace bspview
