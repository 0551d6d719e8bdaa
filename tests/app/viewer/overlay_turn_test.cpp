#include "app/viewer/overlay_turn.h"

#include <gtest/gtest.h>

#include <thread>

#include "app/viewer/requests.h"

namespace bspview {
namespace {

constexpr std::chrono::hours forever(1);  // whoever waits in vain does not pass
constexpr std::chrono::milliseconds no_time(0);

const auto hits = std::make_shared<const FirstHits>();
const auto other_hits = std::make_shared<const FirstHits>();

TEST(OverlayTurnTest, NoPictureWaitsWhereNoOverlayIsExpected) {
  OverlayTurn turn(forever);
  EXPECT_TRUE(turn.wait_for(hits, {}));
}

TEST(OverlayTurnTest, AnOverlayThatIsThereIsNotWaitedFor) {
  OverlayTurn turn(forever);
  turn.expect(true);
  turn.finish(hits);
  EXPECT_TRUE(turn.wait_for(hits, {}));
}

TEST(OverlayTurnTest, TheOverlayOfAnotherPictureEndsNoWait) {
  OverlayTurn turn(no_time);
  turn.expect(true);
  turn.finish(other_hits);
  EXPECT_FALSE(turn.wait_for(hits, {}));
}

TEST(OverlayTurnTest, APictureGoesOnWhenItsOverlayIsThere) {
  OverlayTurn turn(forever);
  turn.expect(true);
  const std::jthread overlay([&] { turn.finish(hits); });
  EXPECT_TRUE(turn.wait_for(hits, {}));
}

TEST(OverlayTurnTest, APictureGoesOnWhenNoOverlayIsExpectedAnyMore) {
  OverlayTurn turn(forever);
  turn.expect(true);
  const std::jthread interface([&] { turn.expect(false); });
  EXPECT_TRUE(turn.wait_for(hits, {}));
}

TEST(OverlayTurnTest, AStopEndsAWait) {
  OverlayTurn turn(forever);
  turn.expect(true);
  std::stop_source stop;
  const std::jthread interface([&] { stop.request_stop(); });
  EXPECT_FALSE(turn.wait_for(hits, stop.get_token()));
}

}  // namespace
}  // namespace bspview
