#include "app/viewer/settings.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/file.h"

namespace bspview {
namespace {

class SettingsTest : public testing::Test {
 protected:
  SettingsTest() {
    char folder[] = "/tmp/bspview_settings_XXXXXX";
    folder_ = mkdtemp(folder);
  }
  ~SettingsTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

Settings unusual_settings() {
  Settings settings;
  settings.window_width = 1111;
  settings.look.theme = Theme::light;
  settings.look.scale = 1.5f;
  settings.look.splits.left = 300.0f;
  settings.look.closed_sections = {"Build"};
  settings.boxes.visible = true;
  settings.boxes.color_by = LeafColor::depth;
  settings.samples = 9;
  settings.measure_times = false;
  return settings;
}

TEST_F(SettingsTest, WhatWasSavedIsLoadedAgain) {
  const std::filesystem::path file = folder_ / "deep" / "er" / "settings.json";
  ASSERT_TRUE(save_settings(unusual_settings(), file));
  EXPECT_EQ(load_settings(file), unusual_settings());
}

TEST_F(SettingsTest, WithoutAFileEverythingIsStandard) {
  EXPECT_EQ(load_settings(folder_ / "none.json"), Settings());
  EXPECT_EQ(load_settings({}), Settings());
}

TEST_F(SettingsTest, WhateverIsInTheFileTheProgramStarts) {
  const std::filesystem::path file = folder_ / "settings.json";
  for (const char* text :
       {"", "{", "[]", "null", "\"x\"", "{\"look\": 3}", "{\"look\": {\"scale\": \"big\"}}",
        "{\"look\": {\"closed\": [1, {}]}, \"boxes\": []}", "{\"samples\": {}}", "\xff\xfe"}) {
    ASSERT_TRUE(write_file(file, text));
    EXPECT_EQ(load_settings(file), Settings()) << text;
  }
}

TEST_F(SettingsTest, NumbersOutOfRangeAreBroughtBack) {
  const std::filesystem::path file = folder_ / "settings.json";
  ASSERT_TRUE(write_file(file, R"({"window_width": -5, "samples": 1e30, "look": {"scale": 99},
                                   "boxes": {"cells": 77, "map": -1}})"));
  const Settings settings = load_settings(file);
  EXPECT_EQ(settings.window_width, 320);
  EXPECT_EQ(settings.samples, 1024);
  EXPECT_EQ(settings.look.scale, largest_scale);
  EXPECT_EQ(settings.boxes.cells, BoxView::Cells::all);
  EXPECT_EQ(settings.boxes.map, ColorMap::viridis);
}

TEST_F(SettingsTest, AFolderThatCannotBeMadeIsASentence) {
  ASSERT_TRUE(write_file(folder_ / "file", "x"));
  const Result<void> saved = save_settings({}, folder_ / "file" / "bspview" / "settings.json");
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message.find("file"), std::string::npos);
}

TEST_F(SettingsTest, TheFileIsInTheUsersConfigurationFolder) {
  setenv("XDG_CONFIG_HOME", "/some/config", 1);
  EXPECT_EQ(settings_file(), "/some/config/bspview/settings.json");
  setenv("XDG_CONFIG_HOME", "relative", 1);
  setenv("HOME", "/some/home", 1);
  EXPECT_EQ(settings_file(), "/some/home/.config/bspview/settings.json");
  unsetenv("XDG_CONFIG_HOME");
  unsetenv("HOME");
  EXPECT_TRUE(settings_file().empty());
}

}  // namespace
}  // namespace bspview
