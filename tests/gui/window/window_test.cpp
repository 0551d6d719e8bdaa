#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/gui/window/stage_play.h"

namespace bspview {
namespace {

using nlohmann::json;

const char* const one_sphere =
    "b 0.1 0.2 0.3\nv\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 64 64\n"
    "l 3 -4 5\nf 0.8 0.3 0.2 0.9 0 0 0 0\ns 0 0 0 1\n";

std::string write(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  const std::string file = folder.file(name);
  std::ofstream(file) << text;
  return file;
}

std::size_t different_pixels(const std::vector<std::uint32_t>& a,
                             const std::vector<std::uint32_t>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

void focus(StagePlay& play) {
  play.user({"search", "--sync", "--onlyvisible", "--name", "bspview", "windowfocus"});
}

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(Window, AUserDragsASliderPicksAPixelAndDropsFiles) {
  // Tests that cost more make leaves so small that a larger leaf size joins them.
  StagePlay play({"spd:tetra:3", "--cost-intersection", "1.5", "--size", "960x600"});
  ASSERT_TRUE(play.client().connected()) << "Xvfb does not start";
  ASSERT_TRUE(play.wait_until_idle()) << play.output();
  focus(play);
  const double leaves = play.state()["delta"]["N_LS"];

  // The slider: the tree, the numbers and the comparison follow.
  play.user_moves(play.point_of("build.leaf_size", 0.03f));
  play.user({"mousedown", "1"});
  for (const float share : {0.2f, 0.4f, 0.6f})
    play.user_moves(play.point_of("build.leaf_size", share));
  play.user({"mouseup", "1"});
  ASSERT_TRUE(play.wait_for([&](const json& state) {
    return state["build"]["leaf_size"] > 2 && state["delta"]["N_LS"] < leaves && !state["busy"];
  })) << play.state().dump();
  EXPECT_EQ(play.state()["before"]["N_LS"], leaves);
  play.user({"key", "ctrl+z"});
  ASSERT_TRUE(play.wait_for([&](const json& state) { return state["delta"]["N_LS"] == leaves; }))
      << play.state().dump() << play.output();

  // A pixel: its ray is followed and drawn.
  const std::vector<std::uint32_t> before_click = play.client().screen();
  play.user_moves(play.point_of("view"));
  play.user({"click", "1"});
  ASSERT_TRUE(play.wait_for([](const json& state) {
    return !state["pick"].is_null() && state["overlay"]["lines"] > 0 && !state["busy"];
  })) << play.state().dump();
  EXPECT_GT(play.state()["pick"]["steps"], 0);
  EXPECT_GT(different_pixels(before_click, play.client().screen()), 100u);

  // A file: it is opened; a broken one is a sentence and changes nothing else.
  const std::vector<std::uint32_t> before_drop = play.client().screen();
  const std::string file = write(play.folder(), "one.nff", one_sphere);
  ASSERT_TRUE(play.client().drop(file));
  ASSERT_TRUE(play.wait_for([&](const json& state) {
    return state["scene"].value("source", "") == file && !state["busy"];
  })) << play.state().dump();
  EXPECT_EQ(play.state()["scene"]["objects"], 1);
  EXPECT_GT(different_pixels(before_drop, play.client().screen()), 10000u);
  ASSERT_TRUE(play.client().drop(write(play.folder(), "broken.nff", "s 1 2\n")));
  ASSERT_TRUE(play.wait_for([](const json& state) { return !state["scene"]["error"].is_null(); }));
  EXPECT_EQ(play.state()["scene"]["objects"], 1);

  play.user({"key", "ctrl+q"});
  EXPECT_EQ(play.program().wait(), 0) << play.output();
  EXPECT_TRUE(std::filesystem::exists(play.folder().file("config/bspview/settings.json")));
}

TEST(Window, NoKeyPressIsLost) {
  StagePlay play({"spd:tetra:1", "--size", "960x600", "--max-depth", "10"});
  ASSERT_TRUE(play.wait_until_idle()) << play.output();
  focus(play);
  // Pressed and released at once, faster than frames are drawn.
  std::vector<std::string> words{"key", "--delay", "0"};
  for (int i = 0; i < 25; ++i) words.push_back("bracketright");
  play.user(words);
  EXPECT_TRUE(play.wait_for([](const json& state) { return state["build"]["max_depth"] == 35; }))
      << play.state()["build"].dump();
  play.user({"key", "--delay", "0", "b", "p", "Tab", "F1"});
  EXPECT_TRUE(play.wait_for([](const json& state) {
    return state["overlay"]["boxes"] == true && state["overlay"]["path"] == false &&
           state["panels"] == false && state["help"] == true;
  })) << play.state().dump();
}

TEST(Window, WhatIsTypedFastIsSeenWithoutAnotherEvent) {
  StagePlay play({"spd:tetra:1", "--size", "960x600"});
  ASSERT_TRUE(play.wait_until_idle()) << play.output();
  focus(play);
  play.user({"key", "ctrl+o"});
  play.user({"type", "--delay", "0", "/nowhere/a_scene_with_a_long_name.nff"});
  play.user({"key", "Return"});
  EXPECT_TRUE(play.wait_for([](const json& state) {
    return state["scene"]["error"].is_string() &&
           state["scene"]["error"].get<std::string>().find("/nowhere/a_scene_with_a_long_name") !=
               std::string::npos;
  })) << play.state()["scene"].dump();
}

TEST(Window, ATooltipAppearsWhileThePointerRests) {
  StagePlay play({"spd:tetra:1", "--size", "960x600"});
  ASSERT_TRUE(play.wait_until_idle()) << play.output();
  focus(play);
  play.user_moves(play.point_of("view", 0.9f));
  ASSERT_TRUE(play.wait_until_idle());
  const std::vector<std::uint32_t> without = play.client().screen();
  play.user_moves(play.point_of("measure.N_RPRT"));
  EXPECT_TRUE(play.wait_for(
      [&](const json&) { return different_pixels(without, play.client().screen()) > 5000; }));
}

TEST(Window, ALongBuildShowsHowFarItIsWithoutAnyEvent) {
  StagePlay play({"spd:gears:9", "--threads", "1", "--size", "960x600"});
  const auto is_building = [](const std::string& work) {
    return work.starts_with("building tree, ") && work != "building tree, 0 %";
  };
  std::string first;
  ASSERT_TRUE(play.wait_for([&](const json& state) {
    first = state["work"];
    return is_building(first);
  })) << play.output();
  EXPECT_TRUE(play.wait_for([&](const json& state) {
    const std::string work = state["work"];
    return is_building(work) && work != first;
  })) << first;
}

TEST(Window, ATreeMayGrowAgainWhileAPixelIsPicked) {
  StagePlay play({"spd:balls:2", "--size", "960x600"});
  ASSERT_TRUE(play.wait_until_idle()) << play.output();
  focus(play);
  play.user_moves(play.point_of("view"));
  play.user({"click", "1"});
  ASSERT_TRUE(play.wait_for([](const json& state) { return !state["pick"].is_null(); }));
  for (const char* name : {"braceright", "braceleft", "bracketleft", "bracketright"}) {
    for (int i = 0; i < 3; ++i) play.user({"key", name});
    ASSERT_TRUE(play.wait_until_idle()) << name << ": " << play.output();
  }
  EXPECT_GT(play.state()["pick"]["steps"], 0);
}

TEST(Window, OpensThroughEglWhereTheServerHasNoGlxAndTheHomeCannotBeWritten) {
  StagePlay play({"spd:tetra:1", "--size", "960x600"}, {"-extension", "GLX"});
  std::filesystem::permissions(play.folder().path(), std::filesystem::perms::owner_all);
  ASSERT_TRUE(play.wait_until_idle()) << play.output();
  write(play.folder(), "config", "a file where the folder should be");
  focus(play);
  play.user({"key", "ctrl+q"});
  EXPECT_EQ(play.program().wait(), 0) << play.output();
}

/// Runs the program without any display; `output` takes what it says.
int run_without_display(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), BSPVIEW_PROGRAM);
  return run(arguments,
             {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"HOME", folder.path().string()}},
             folder.file("output"));
}

std::string output_of(const TemporaryFolder& folder) {
  std::ifstream stream(folder.file("output"));
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(WithoutDisplay, TheWindowIsRefusedInOneSentence) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_without_display(folder, {"spd:tetra:1"}), 1);
  const std::string text = output_of(folder);
  EXPECT_NE(text.find("no display"), std::string::npos) << text;
  EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WithoutDisplay, AScreenshotIsDrawnOffScreen) {
  const TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  EXPECT_EQ(run_without_display(folder, {"spd:tetra:1", "--screenshot", file, "--size", "640x400",
                                         "--pick", "100,100", "--boxes", "on"}),
            0)
      << output_of(folder);
  EXPECT_GT(std::filesystem::file_size(file), 10000u);
}

TEST(WithoutDisplay, AScreenshotComesWithItsStateAndItsWidgets) {
  const TemporaryFolder folder;
  const std::string scene = write(folder, "bad\xff.nff", one_sphere);  // not UTF-8
  EXPECT_EQ(run_without_display(folder, {scene, "--screenshot", folder.file("a.png"), "--size",
                                         "640x400", "--state", folder.file("state.json"),
                                         "--ui-map", folder.file("widgets.json")}),
            0)
      << output_of(folder);
  std::ifstream state(folder.file("state.json")), widgets(folder.file("widgets.json"));
  EXPECT_EQ(json::parse(state)["scene"]["objects"], 1);
  EXPECT_TRUE(json::parse(widgets).contains("view"));
}

TEST(WithoutDisplay, WhatCannotBeDrawnFailsWithOneSentenceAndNoFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  EXPECT_EQ(run_without_display(folder, {"/no/scene.nff", "--screenshot", file}), 1);
  EXPECT_NE(output_of(folder).find("/no/scene.nff"), std::string::npos) << output_of(folder);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(run_without_display(folder, {"spd:tetra:1", "--screenshot", "/no/folder/x.png"}), 1);
  EXPECT_EQ(run_without_display(folder, {"spd:tetra:1", "--screenshot", file, "--pick", "99999,5"}),
            1);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(run_without_display(folder, {"spd:tetra:1", "--screenshot", "picture.jpg"}), 2);
  EXPECT_EQ(run_without_display(folder, {"--pick", "here"}), 2);
  EXPECT_EQ(run_without_display(folder, {"--size", "0x0"}), 2);
}

TEST(WithoutDisplay, AScriptReplaysInputAndSavesWhatItSees) {
  const TemporaryFolder folder;
  const std::string state = folder.file("state.json");
  const std::string script =
      write(folder, "script.txt", "wait\nclick view\nkey B\nwait\nstate " + state + "\n");
  EXPECT_EQ(run_without_display(folder, {"spd:tetra:2", "--size", "640x400", "--script", script}),
            0)
      << output_of(folder);
  std::ifstream stream(state);
  const json saved = json::parse(stream, nullptr, false);
  ASSERT_TRUE(saved.is_object());
  EXPECT_EQ(saved["overlay"]["boxes"], true);
  EXPECT_FALSE(saved["pick"].is_null());
}

}  // namespace
}  // namespace bspview
