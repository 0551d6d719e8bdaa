#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>

#include "app/viewer/work.h"

namespace bspview {
namespace {

constexpr std::chrono::hours forever(1);  // whoever waits in vain does not pass

TEST(OverlayWork, GivesTheTurnBackWhenTheOverlayIsThere) {
  const auto turn = std::make_shared<OverlayTurn>(forever);
  turn->expect(true);
  const auto hits = std::make_shared<const FirstHits>();
  const OverlayRequest request{.first_hits = hits, .width = 8, .height = 8};
  EXPECT_TRUE(OverlayWork(turn)(request, {}, [](const auto&) {}).ok());
  EXPECT_TRUE(turn->wait_for(hits, {}));
}

TEST(OverlayWork, GivesTheTurnBackWhenItIsStopped) {
  const auto turn = std::make_shared<OverlayTurn>(forever);
  turn->expect(true);
  const auto hits = std::make_shared<const FirstHits>();
  const OverlayRequest request{.first_hits = hits, .width = 8, .height = 8};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(OverlayWork(turn)(request, stop.get_token(), [](const auto&) { FAIL(); }).ok());
  EXPECT_TRUE(turn->wait_for(hits, {}));
}

/// A picture of a small scene, of as many passes as a picture has.
PictureRequest small_picture() {
  std::shared_ptr<const BuiltTree> built;
  EXPECT_TRUE(open_scene({"spd:tetra:2"}, {}, [&](auto scene) {
                TreeWork trees;
                EXPECT_TRUE(trees({scene, {}}, {}, [&](auto tree) { built = tree; }).ok());
              }).ok());
  return {built, built->request.scene->scene.camera, {.width = 16, .height = 16, .samples = 4}};
}

TEST(PictureWork, WaitsForTheOverlayOfAFirstLookAndOfNothingElse) {
  const auto turn = std::make_shared<OverlayTurn>(forever);
  PictureWork work(turn);
  const PictureRequest request = small_picture();
  ASSERT_TRUE(work(request, {}, [](const auto&) {}).ok());  // nobody expects an overlay
  turn->expect(true);
  std::promise<std::shared_ptr<const Picture>> look;
  std::atomic<int> published = 0;
  auto again = std::async(std::launch::async, [&] {
    const auto done = work(request, {}, [&](const auto& picture) {
      if (published++ == 0) look.set_value(picture);
    });
    if (published == 0) look.set_value(nullptr);
    return done.ok();
  });
  const std::shared_ptr<const Picture> seen = look.get_future().get();
  ASSERT_TRUE(seen);
  EXPECT_EQ(again.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  EXPECT_EQ(published, 1);
  turn->finish(seen->first_hits);
  EXPECT_TRUE(again.get());
  EXPECT_GT(published, 1);
}

}  // namespace
}  // namespace bspview
