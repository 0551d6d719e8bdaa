#include "app/viewer/stage.h"

#include <gtest/gtest.h>

#include <atomic>
#include <semaphore>
#include <string>

namespace bspview {
namespace {

using Numbers = Stage<int, std::string>;
using namespace std::chrono_literals;

/// Lets a test sleep until a stage has news.
class Bell {
 public:
  std::function<void()> ring() {
    return [this] { rung_.release(); };
  }
  /// Calls want(request) after every ring until `done`.
  template <class S, class Done>
  void wait(S& stage, int request, const Done& done) {
    for (stage.want(request); !done(); stage.want(request)) (void)rung_.try_acquire_for(10ms);
  }

 private:
  std::counting_semaphore<1 << 20> rung_{0};
};

void sleep_until_stopped(std::stop_token stop) {
  while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
}

TEST(Stage, ShowsWhatItsWorkPublishes) {
  Bell bell;
  Numbers stage(
      [](int n, std::stop_token, const Numbers::Publish& publish) -> Result<void> {
        publish(std::make_shared<const std::string>(std::to_string(n)));
        return {};
      },
      bell.ring());
  EXPECT_EQ(stage.value(), nullptr);
  bell.wait(stage, 7, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "7");
  EXPECT_FALSE(stage.error());
}

TEST(Stage, DoesNotRepeatAWishThatComparesEqual) {
  Bell bell;
  std::atomic<int> jobs = 0;
  Numbers stage(
      [&](int, std::stop_token, const Numbers::Publish&) -> Result<void> {
        ++jobs;
        return {};
      },
      bell.ring());
  bell.wait(stage, 1, [&] { return !stage.busy(); });
  for (int i = 0; i < 100; ++i) stage.want(1);
  EXPECT_FALSE(stage.busy());
  EXPECT_EQ(jobs, 1);
}

TEST(Stage, TheLatestWishWinsAndTheWorkUnderWayIsStopped) {
  Bell bell;
  Numbers stage(
      [](int n, std::stop_token stop, const Numbers::Publish& publish) -> Result<void> {
        if (n < 100) {
          sleep_until_stopped(stop);
          publish(std::make_shared<const std::string>("late"));
          return Error{"stopped"};
        }
        publish(std::make_shared<const std::string>(std::to_string(n)));
        return {};
      },
      bell.ring());
  for (int n = 0; n < 100; ++n) stage.want(n);
  bell.wait(stage, 100, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "100");
  EXPECT_FALSE(stage.error());
}

TEST(Stage, KeepsTheOldValueWhenMemoryRunsOut) {
  Bell bell;
  Numbers stage(
      [](int n, std::stop_token, const Numbers::Publish& publish) -> Result<void> {
        if (n < 0) throw std::bad_alloc();
        publish(std::make_shared<const std::string>(std::to_string(n)));
        return {};
      },
      bell.ring());
  bell.wait(stage, 3, [&] { return !stage.busy(); });
  bell.wait(stage, -1, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "3");
  ASSERT_TRUE(stage.error());
  EXPECT_EQ(stage.error()->message, "there is not enough memory");
}

TEST(Stage, KeepsTheOldValueWhenTheWorkFails) {
  Bell bell;
  Numbers stage(
      [](int n, std::stop_token, const Numbers::Publish& publish) -> Result<void> {
        if (n < 0) return Error{"there is no number below 0"};
        publish(std::make_shared<const std::string>(std::to_string(n)));
        return {};
      },
      bell.ring());
  bell.wait(stage, 3, [&] { return !stage.busy(); });
  bell.wait(stage, -1, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "3");
  ASSERT_TRUE(stage.error());
  EXPECT_EQ(stage.error()->message, "there is no number below 0");
  bell.wait(stage, 4, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "4");
  EXPECT_FALSE(stage.error());
}

TEST(Stage, PatienceLetsWorkPublishOnceBeforeANewerWishStopsIt) {
  Bell bell;
  std::binary_semaphore started{0}, go_on{0};
  Numbers stage(
      [&](int n, std::stop_token stop, const Numbers::Publish& publish) -> Result<void> {
        if (n == 1) {
          started.release();
          go_on.acquire();
          EXPECT_FALSE(stop.stop_requested());
          publish(std::make_shared<const std::string>("first pixels"));
          EXPECT_TRUE(stop.stop_requested());
        }
        return {};
      },
      bell.ring(), {1h});
  stage.want(1);
  started.acquire();
  stage.want(2);
  EXPECT_TRUE(stage.drop_due());
  go_on.release();
  bell.wait(stage, 2, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "first pixels");
}

TEST(Stage, WorkThatServesANewerWishGoesOn) {
  Bell bell;
  std::binary_semaphore started{0}, go_on{0};
  const auto work = [&](int n, std::stop_token stop, const Numbers::Publish& publish) {
    if (n == 10) {
      started.release();
      go_on.acquire();
      EXPECT_FALSE(stop.stop_requested());
    }
    if (n == 50) {
      started.release();
      sleep_until_stopped(stop);
    }
    if (stop.stop_requested()) return Result<void>(Error{"stopped"});
    publish(std::make_shared<const std::string>(std::to_string(n)));
    return Result<void>();
  };
  Numbers stage(work, bell.ring(), {0s, [](int wish) { return wish < 100; }});
  stage.want(10);
  started.acquire();
  stage.want(20);
  EXPECT_FALSE(stage.drop_due());
  go_on.release();
  bell.wait(stage, 20, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "20");

  stage.want(50);
  started.acquire();
  bell.wait(stage, 100, [&] { return !stage.busy(); });
  EXPECT_EQ(*stage.value(), "100");
}

TEST(Stage, WantingNothingDropsValueAndWork) {
  Bell bell;
  Numbers stage(
      [](int n, std::stop_token stop, const Numbers::Publish& publish) -> Result<void> {
        if (n == 2) sleep_until_stopped(stop);
        publish(std::make_shared<const std::string>(std::to_string(n)));
        return {};
      },
      bell.ring());
  bell.wait(stage, 1, [&] { return !stage.busy(); });
  stage.want(2);
  stage.want(std::nullopt);
  EXPECT_EQ(stage.value(), nullptr);
  while (stage.busy()) stage.want(std::nullopt);
  EXPECT_EQ(stage.value(), nullptr);
}

TEST(Stage, EndsPromptlyWhileWorkIsUnderWay) {
  Bell bell;
  std::binary_semaphore started{0};
  bool stopped = false;
  {
    Numbers stage(
        [&](int, std::stop_token stop, const Numbers::Publish&) -> Result<void> {
          started.release();
          sleep_until_stopped(stop);
          stopped = true;
          return {};
        },
        bell.ring());
    stage.want(1);
    started.acquire();
  }
  EXPECT_TRUE(stopped);
}

}  // namespace
}  // namespace bspview
