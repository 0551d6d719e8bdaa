#include "tests/architecture/include_rules.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/file.h"

namespace bspview::test {
namespace {

namespace fs = std::filesystem;

bool allowed(std::string_view file, std::string_view included) {
  return !find_broken_rule(file, included);
}

TEST(IncludeRules, HoldInEverySourceFile) {
  const fs::path root = BSPVIEW_SOURCE_DIR;
  std::size_t checked = 0;
  for (const std::string_view top : {"core", "app", "tests"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), root).string();
      const Result<std::string> text = read_file(entry.path());
      ASSERT_TRUE(text.ok()) << text.error().message;
      for (const std::string& included : includes_of(*text)) {
        const auto broken = find_broken_rule(file, included);
        EXPECT_FALSE(broken.has_value()) << file << " " << *broken;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 100u);
}

TEST(IncludeRules, FindAnArrowThatRunsBack) {
  EXPECT_FALSE(allowed("core/base/timer.h", "core/math/vec.h"));
  EXPECT_FALSE(allowed("core/bsp/build.cpp", "core/render/render.h"));
  EXPECT_FALSE(allowed("core/eval/delta.cpp", "app/options/values.h"));
  EXPECT_FALSE(allowed("app/viewer/overlays/node_boxes.h", "app/viewer/app.h"));
  EXPECT_FALSE(allowed("core/scene/scene.cpp", "tests/support/scenes.h"));
  EXPECT_FALSE(allowed("tests/support/scenes.h", "tests/core/bsp/builders.h"));
}

TEST(IncludeRules, FindFoldersThatDoNotKnowEachOther) {
  EXPECT_FALSE(allowed("core/bsp/tree.h", "core/scene/scene.h"));
  EXPECT_FALSE(allowed("core/scene/scene.h", "core/bsp/tree.h"));
  EXPECT_FALSE(allowed("app/eval/main.cpp", "app/viewer/picking.h"));
  EXPECT_FALSE(allowed("app/viewer/app.cpp", "app/eval/stats.h"));
}

TEST(IncludeRules, FindLibrariesOutsideTheirPlace) {
  EXPECT_FALSE(allowed("core/scene/scene.h", "GL/gl.h"));
  EXPECT_FALSE(allowed("app/viewer/panels/build_panel.cpp", "GLFW/glfw3.h"));
  EXPECT_FALSE(allowed("app/viewer/panels/build_panel.cpp", "GL/gl.h"));
  EXPECT_FALSE(allowed("app/viewer/app.cpp", "backends/imgui_impl_opengl3.h"));
  EXPECT_FALSE(allowed("app/viewer/overlays/node_boxes.cpp", "imgui.h"));
  EXPECT_FALSE(allowed("app/viewer/stage.h", "imgui_internal.h"));
  EXPECT_FALSE(allowed("app/eval/main.cpp", "EGL/egl.h"));
}

TEST(IncludeRules, FindAFolderThatIsNotInTheArchitecture) {
  EXPECT_FALSE(allowed("core/util/misc.h", "vector"));
}

TEST(IncludeRules, LetTheArrowsOfTheArchitecturePass) {
  EXPECT_TRUE(allowed("core/bsp/build.cpp", "core/bsp/tree.h"));
  EXPECT_TRUE(allowed("core/bsp/build.cpp", "core/shape/triangle.h"));
  EXPECT_TRUE(allowed("core/render/scene_tree.h", "core/scene/scene.h"));
  EXPECT_TRUE(allowed("app/viewer/panels/build_panel.cpp", "app/viewer/actions.h"));
  EXPECT_TRUE(allowed("app/viewer/panels/build_panel.cpp", "imgui.h"));
  EXPECT_TRUE(allowed("app/viewer/window.cpp", "GLFW/glfw3.h"));
  EXPECT_TRUE(allowed("app/viewer/gl/texture.cpp", "GL/gl.h"));
  EXPECT_TRUE(allowed("tests/app/viewer/layout_test.cpp", "imgui.h"));
  EXPECT_TRUE(allowed("core/base/file.cpp", "unistd.h"));
}

TEST(IncludeRules, SeeEveryFormOfAnInclude) {
  const std::vector<std::string> included = {"a.h", "b/c.h", "d", "e"};
  EXPECT_EQ(includes_of("#include \"a.h\"\n  # include <b/c.h>\nint x; // #include <no>\n"
                        "#include\t<d> // why\r\n#include<e>"),
            included);
}

}  // namespace
}  // namespace bspview::test
