#include "core/base/run_time.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/parallel.h"

namespace bspview {
namespace {

TEST(RunTime, OneThreadRunsTheWorkItself) {
  const auto caller = std::this_thread::get_id();
  std::atomic<int> elsewhere = 0;
  const double seconds = time_run(1, [&] {
    parallel_for(100, [&](int) { elsewhere += std::this_thread::get_id() == caller ? 0 : 1; });
  });
  EXPECT_EQ(elsewhere, 0);
  EXPECT_GE(seconds, 0.0);
}

TEST(RunTime, WaitingCountsOnTheClockOfTheWallAlone) {
  constexpr std::chrono::milliseconds wait(50);
  const auto sleep = [&] { std::this_thread::sleep_for(wait); };
  EXPECT_LT(time_run(1, sleep), 0.05);
  EXPECT_GE(time_run(2, sleep), 0.05);
}

}  // namespace
}  // namespace bspview
