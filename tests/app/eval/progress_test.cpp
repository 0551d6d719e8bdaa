#include "app/eval/progress.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(Progress, ShowsShareRateAndTimeLeft) {
  EXPECT_EQ(format_progress("rays", {.done = 500'000, .total = 2'000'000, .seconds = 0.5}),
            "rays [#######-----------------------]  25 %  1.0 M/s  2 s left");
  EXPECT_EQ(format_progress("runs", {.done = 1, .total = 1000, .seconds = 10.0}),
            "runs [------------------------------]   0 %  0.1/s  2:46 h left");
  EXPECT_EQ(format_progress("rays", {.done = 30'000, .total = 300'000, .seconds = 10.0}),
            "rays [###---------------------------]  10 %  3.0 k/s  1:30 min left");
}

TEST(Progress, BeginsWithoutARateAndEndsAtHundred) {
  EXPECT_EQ(format_progress("x", {.done = 0, .total = 5, .seconds = 1.0}),
            "x [------------------------------]   0 %");
  EXPECT_EQ(format_progress("x", {.done = 5, .total = 5, .seconds = 1.0}),
            "x [##############################] 100 %  5.0/s  0 s left");
  EXPECT_EQ(format_progress("x", {.done = 9, .total = 0, .seconds = 1.0}).substr(0, 34),
            "x [##############################]");
}

TEST(Progress, IsSilentWhenStderrIsNoTerminal) {
  ::testing::internal::CaptureStderr();
  {
    Progress progress("rays", 10, Progress::Mode::shown);
    progress.add(5);
    progress.add(4);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace bspview
