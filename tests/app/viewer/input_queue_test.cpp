#include "app/viewer/input_queue.h"

#include <gtest/gtest.h>

#include "app/viewer/key.h"

namespace bspview {
namespace {

class InputQueueTest : public testing::Test {
 protected:
  InputQueueTest() : context_(ImGui::CreateContext()) {}
  ~InputQueueTest() override { ImGui::DestroyContext(context_); }

  ImGuiIO& io() { return ImGui::GetIO(); }
  InputQueue queue_;

 private:
  ImGuiContext* context_;
};

TEST_F(InputQueueTest, AKeyPressedAndReleasedAtOnceIsSeenPressedForOneFrame) {
  queue_.push(InputEvent::key(key::f1, true));
  queue_.push(InputEvent::key(key::f1, false));
  queue_.feed(io());
  EXPECT_TRUE(io().KeysDown[key::f1]);
  EXPECT_FALSE(queue_.empty());
  queue_.feed(io());
  EXPECT_FALSE(io().KeysDown[key::f1]);
  EXPECT_TRUE(queue_.empty());
}

TEST_F(InputQueueTest, AModifierIsHeldUntilTheKeyItBelongsToWasSeen) {
  for (const bool down : {true, false})
    for (const int code : {key::left_control, int{'S'}}) queue_.push(InputEvent::key(code, down));
  queue_.feed(io());
  EXPECT_TRUE(io().KeyCtrl && io().KeysDown['S']);
  queue_.feed(io());
  EXPECT_FALSE(io().KeyCtrl || io().KeysDown['S']);
}

TEST_F(InputQueueTest, AModifierHeldBeforeAndReleasedFirstStillCounts) {
  queue_.push(InputEvent::key(key::left_control, true));
  queue_.feed(io());
  queue_.push(InputEvent::key('Z', true));
  queue_.push(InputEvent::key(key::left_control, false));
  queue_.push(InputEvent::key('Z', false));
  queue_.feed(io());
  EXPECT_TRUE(io().KeyCtrl && io().KeysDown['Z']);
  queue_.feed(io());
  EXPECT_FALSE(io().KeyCtrl || io().KeysDown['Z']);
}

TEST_F(InputQueueTest, AModifierPressedAfterAKeyDoesNotReachBackToIt) {
  queue_.push(InputEvent::key('Z', true));
  queue_.push(InputEvent::key(key::left_control, true));
  queue_.feed(io());
  EXPECT_TRUE(io().KeysDown['Z']);
  EXPECT_FALSE(io().KeyCtrl);
}

TEST_F(InputQueueTest, ADragIsSeenAtItsEndBeforeTheButtonIsReleased) {
  queue_.push(InputEvent::button(0, true));
  queue_.feed(io());
  queue_.push(InputEvent::move({10, 20}));
  queue_.push(InputEvent::move({90, 20}));
  queue_.push(InputEvent::button(0, false));
  queue_.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_EQ(io().MousePos.x, 90);
  queue_.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
}

TEST_F(InputQueueTest, AClickHappensWhereThePointerWas) {
  queue_.push(InputEvent::move({10, 20}));
  queue_.push(InputEvent::button(0, true));
  queue_.push(InputEvent::move({300, 400}));
  queue_.push(InputEvent::button(0, false));
  queue_.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_EQ(io().MousePos.x, 10);
  queue_.feed(io());
  EXPECT_EQ(io().MousePos.x, 300);
  queue_.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
}

TEST_F(InputQueueTest, ManyPressesInOneFrameAreAllSeen) {
  for (int i = 0; i < 20; ++i) queue_.push(InputEvent::key(']', i % 2 == 0));
  int presses = 0;
  for (bool before = false; !queue_.empty(); before = io().KeysDown[']']) {
    queue_.feed(io());
    presses += io().KeysDown[']'] && !before ? 1 : 0;
  }
  EXPECT_EQ(presses, 10);
}

TEST_F(InputQueueTest, NumbersThatNoKeyHasAreIgnored) {
  queue_.push(InputEvent::key(-1, true));
  queue_.push(InputEvent::key(100000, true));
  queue_.push(InputEvent::button(9, true));
  queue_.feed(io());
  EXPECT_TRUE(queue_.empty());
}

}  // namespace
}  // namespace bspview
