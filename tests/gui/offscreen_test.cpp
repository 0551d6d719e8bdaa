#include "app/viewer/offscreen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "app/viewer/gl/screen.h"
#include "app/viewer/interface.h"
#include "app/viewer/session.h"

namespace bspview {
namespace {

constexpr WindowSize size{640, 400, 640, 400, 1.0f};

State small_scene() {
  State state;
  state.source = "spd:tetra:2";
  state.picture.samples = 1;
  state.measure_times = false;
  return state;
}

class OffscreenTest : public testing::Test {
 protected:
  void SetUp() override {
    Result<std::unique_ptr<Offscreen>> offscreen = Offscreen::create(size);
    ASSERT_TRUE(offscreen) << offscreen.error().message;
    offscreen_ = *std::move(offscreen);
  }

  /// Frames until nothing is left to compute.
  void settle(Session& session) {
    for (int idle = 0; idle < 3;) {
      session.frame(size, 1.0f / 60);
      const bool resting = !session.app().busy() && !session.app().next_frame_in();
      idle = resting ? idle + 1 : 0;
      if (!resting) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  std::uint32_t pixel(int x, int y) const {
    return gl::read_pixels(size.pixel_width,
                           size.pixel_height)[static_cast<std::size_t>(y * size.pixel_width + x)];
  }

  std::unique_ptr<Offscreen> offscreen_;
};

TEST_F(OffscreenTest, OffersTheOpenGLThatTheViewerNeeds) {
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(major * 10 + minor, 33);
}

TEST_F(OffscreenTest, ThePictureArrivesOnTheScreenPixelByPixel) {
  const auto session = Session::create(small_scene(), [] {});
  ASSERT_TRUE(session);
  (*session)->app().state().panels_visible = false;
  settle(**session);
  const Results& results = (*session)->app().results();
  ASSERT_TRUE(results.picture);
  ASSERT_EQ(results.picture->request.params.width, size.width);
  EXPECT_EQ(gl::read_pixels(size.pixel_width, size.pixel_height), *results.picture->pixels);
}

TEST_F(OffscreenTest, TheOverlayLiesOverThePicture) {
  State state = small_scene();
  state.boxes.visible = true;
  state.boxes.cells = BoxView::Cells::all;
  state.panels_visible = false;
  const auto session = Session::create(state, [] {});
  ASSERT_TRUE(session);
  settle(**session);
  const Results& results = (*session)->app().results();
  ASSERT_TRUE(results.overlay);
  const std::vector<std::uint32_t> screen = gl::read_pixels(size.pixel_width, size.pixel_height);
  const std::vector<std::uint32_t>& layer = results.overlay->layer.pixels;
  const std::vector<std::uint32_t>& picture = *results.picture->pixels;
  const Rect legend = (*session)->app().widgets().at("legend");
  std::size_t covered = 0;
  for (std::size_t i = 0; i < screen.size(); ++i) {
    const Vec2 at(static_cast<float>(i % size.width), static_cast<float>(i / size.width));
    if (legend.contains(at)) continue;
    const std::uint32_t alpha = layer[i] >> 24;
    if (alpha != 0x00 && alpha != 0xff) continue;
    ASSERT_EQ(screen[i], alpha == 0 ? picture[i] : layer[i]);
    covered += alpha == 0 ? 0 : 1;
  }
  EXPECT_GT(covered, 100u);
}

TEST_F(OffscreenTest, PanelsCoverTheirRegionsAndChangeWithTheTheme) {
  const auto session = Session::create(small_scene(), [] {});
  ASSERT_TRUE(session);
  settle(**session);
  const std::uint32_t dark = pixel(3, 200);
  (*session)->app().state().look.theme = Theme::light;
  settle(**session);
  const std::uint32_t light = pixel(3, 200);
  EXPECT_EQ(dark, ImGui::ColorConvertFloat4ToU32(palette_of(Theme::dark).panel));
  EXPECT_EQ(light, ImGui::ColorConvertFloat4ToU32(palette_of(Theme::light).panel));
}

TEST_F(OffscreenTest, AnotherScaleUploadsItsFonts) {
  const auto session = Session::create(small_scene(), [] {});
  ASSERT_TRUE(session);
  for (const float scale : {1.0f, 2.0f, 0.75f}) {
    (*session)->app().state().look.scale = scale;
    (*session)->frame(size, 1.0f / 60);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

}  // namespace
}  // namespace bspview
