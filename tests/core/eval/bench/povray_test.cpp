#include "core/eval/bench/povray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/eval/bench/povray_scene.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

std::ptrdiff_t count(std::string_view text, std::string_view word) {
  std::ptrdiff_t found = 0;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Povray, TheSceneIsWrittenWithAllItsParts) {
  Scene scene = test::random_scene(200, 1);
  const ObjectCounts objects = count_objects(scene);
  const std::string text = to_povray(scene, 5);
  EXPECT_EQ(count(text, "light_source"), static_cast<std::ptrdiff_t>(scene.lights.size()));
  EXPECT_EQ(count(text, "\nsphere {"), static_cast<std::ptrdiff_t>(objects.spheres));
  EXPECT_EQ(count(text, "\ncone {"), static_cast<std::ptrdiff_t>(objects.cones));
  EXPECT_EQ(count(text, "#declare M"), static_cast<std::ptrdiff_t>(scene.materials.size()));
  EXPECT_NE(text.find("max_trace_level 5"), std::string::npos);
  EXPECT_EQ(std::ranges::count(text, '{'), std::ranges::count(text, '}'));
}

TEST(Povray, DegenerateObjectsAreLeftOut) {
  Scene scene;
  add_sphere(scene, add_material(scene, {}), {{0, 0, 0}, 0.0f});
  EXPECT_EQ(count(to_povray(scene, 5), "sphere"), 0);
}

TEST(Povray, ItsTimeOfTracingIsRead) {
  const char* messages =
      "  Parse Time:       0 hours  0 minutes  0 seconds (0.033 seconds)\n"
      "              using 1 thread(s) with 0.016 CPU-seconds total\n"
      "  Trace Time:       0 hours  0 minutes  1 seconds (1.606 seconds)\n"
      "              using 1 thread(s) with 0.737 CPU-seconds total\n";
  EXPECT_EQ(povray_trace_seconds(messages), 0.737);
  EXPECT_FALSE(povray_trace_seconds("POV-Ray finished"));
  EXPECT_FALSE(povray_trace_seconds("Trace Time: with nothing"));
}

TEST(Povray, ThePicturesOfBothAreTimedInTurns) {
  // Stands in for POV-Ray: says that it took 2 s.
  const std::string program = (std::filesystem::temp_directory_path() / "bspview_povray").string();
  ASSERT_TRUE(write_file(program,
                         "#!/bin/sh\ntest -s scene.pov || exit 1\n"
                         "echo 'Trace Time: using 1 thread(s) with 2.0 CPU-seconds total'\n")
                  .ok());
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  PovrayParams params;
  params.program = program;
  params.side = 16;
  params.repeats = 2;
  const Scene scene = test::random_scene(50, 2);
  const auto report = run_povray(std::span(&scene, 1), params);
  std::filesystem::remove(program);
  ASSERT_TRUE(report.ok()) << report.error().message;
  const PictureTimes& times = report->pictures[0];
  EXPECT_EQ(times.boxes, (std::vector<double>{2.0, 2.0}));
  EXPECT_EQ(times.bsp, times.boxes);
  EXPECT_GT(povray_ratio(times), 1.0);
  EXPECT_EQ(nlohmann::json::parse(to_json(*report))["pictures"].size(), 1u);
  EXPECT_EQ(std::ranges::count(to_csv(*report), '\n'), 2);
  EXPECT_NE(to_text(*report).find("times as fast as by POV-Ray"), std::string::npos);
}

TEST(Povray, AProgramThatIsNotThereIsNamed) {
  PovrayParams params;
  params.program = "no-such-povray";
  const Scene scene = test::random_scene(5, 2);
  const auto report = run_povray(std::span(&scene, 1), params);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().message, "no-such-povray: does not run; install povray for --povray");
}

}  // namespace
}  // namespace bspview
