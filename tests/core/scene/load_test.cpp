#include "core/scene/load.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/file.h"

namespace bspview {
namespace {

namespace fs = std::filesystem;

/// An empty folder of its own, gone after the test.
class LoadScene : public testing::Test {
 protected:
  LoadScene() {
    std::string name = (fs::temp_directory_path() / "bspview_load_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~LoadScene() override { fs::remove_all(folder_); }

  /// A file of that name and content.
  std::string file(const std::string& name, std::string_view text) const {
    EXPECT_TRUE(write_file(folder_ / name, text).ok());
    return (folder_ / name).string();
  }

  fs::path folder_;
};

std::string error_of(const std::string& source) {
  const Result<Scene> scene = load_scene(source);
  return scene ? "no error" : scene.error().message;
}

TEST_F(LoadScene, ChoosesTheFormatByTheExtensionInAnyCase) {
  for (const std::string name : {"one.nff", "one.NFF", "one.Nff", "a.b c\xC3\xA4.nff"}) {
    const Result<Scene> scene = load_scene(file(name, "s 0 0 0 1"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->name, name.substr(0, name.size() - 4));
  }
}

TEST_F(LoadScene, MakesStandardScenesWithAndWithoutSize) {
  const Result<Scene> standard = load_scene("spd:tetra");
  const Result<Scene> small = load_scene("spd:tetra:2");
  ASSERT_TRUE(standard.ok() && small.ok());
  EXPECT_EQ(standard->objects.size(), 4096u);
  EXPECT_EQ(small->objects.size(), 16u);
}

TEST_F(LoadScene, SaysInOneSentenceWhyThereIsNoScene) {
  const std::string here = folder_.string();
  EXPECT_EQ(error_of(""), "the name of the scene is empty");
  EXPECT_EQ(error_of(here + "/x.nff"), here + "/x.nff: there is no such file");
  EXPECT_EQ(error_of(here), here + ": is a folder, not a scene");
  EXPECT_EQ(error_of(file("x", "")),
            here +
                "/x: has no extension, which names no scene format (.nff, or spd:NAME[:SIZE] for "
                "a standard scene)");
  EXPECT_EQ(error_of(file("x.foo", "")),
            here +
                "/x.foo: has the extension .foo, which names no scene format (.nff, or "
                "spd:NAME[:SIZE] for a standard scene)");
  EXPECT_EQ(error_of(file("empty.nff", "")), here + "/empty.nff:1: the file holds no object");
  EXPECT_EQ(error_of(file("y.nff", "s 0 0 0\n1 2")),
            here + "/y.nff:2: expected one of the records v, b, l, f, s, c, p and pp, found `2`");
  EXPECT_EQ(error_of("spd:balls:x"), "spd:balls:x: `x` is no size factor, which is a whole number");
  EXPECT_EQ(error_of("spd:balls:"), "spd:balls:: `` is no size factor, which is a whole number");
  EXPECT_NE(error_of("spd:"), "no error");
  EXPECT_NE(error_of("spd:cube"), "no error");
  EXPECT_NE(error_of("spd:balls:0"), "no error");
  EXPECT_NE(error_of("spd:balls:99999999999"), "no error");
}

TEST_F(LoadScene, AFileThatMayNotBeReadIsNamed) {
  const std::string name = file("secret.nff", "s 0 0 0 1");
  fs::permissions(name, fs::perms::none);
  const Result<Scene> scene = load_scene(name);
  // The super-user reads everything.
  if (geteuid() == 0) {
    EXPECT_TRUE(scene.ok());
  } else {
    EXPECT_EQ(scene.error().message, name + ": cannot be opened: Permission denied");
  }
}

TEST_F(LoadScene, WhatIsSavedLoadsAgain) {
  const Result<Scene> scene = load_scene("spd:balls:2");
  ASSERT_TRUE(scene.ok());
  ASSERT_TRUE(save_nff(*scene, folder_ / "balls.nff").ok());
  const Result<Scene> back = load_scene((folder_ / "balls.nff").string());
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_EQ(back->objects, scene->objects);
  EXPECT_EQ(back->spheres, scene->spheres);
  EXPECT_EQ(back->vertices, scene->vertices);
  EXPECT_EQ(back->camera, scene->camera);
}

TEST_F(LoadScene, AFailedSaveLeavesNothingBehind) {
  const std::string missing = (folder_ / "none" / "a.nff").string();
  EXPECT_FALSE(save_nff({}, missing).ok());
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace bspview
