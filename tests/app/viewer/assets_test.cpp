#include <gtest/gtest.h>

#include <filesystem>

#include "core/scene/load.h"

namespace bspview {
namespace {

TEST(Assets, EverySampleSceneIsReadAndHasNothingDegenerate) {
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(BSPVIEW_SOURCE_DIR "/assets/scenes")) {
    const Result<Scene> scene = load_scene(entry.path().string());
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_FALSE(scene->lights.empty());
    for (std::uint32_t object = 0; object < scene->objects.size(); ++object)
      EXPECT_FALSE(is_degenerate(*scene, object)) << entry.path() << ", object " << object;
    ++scenes;
  }
  EXPECT_GT(scenes, 0);
}

}  // namespace
}  // namespace bspview
