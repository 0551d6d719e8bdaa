#include "core/scene/load.h"
#include "core/scene/spd.h"
#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

using Spd = Bspeval;

TEST_F(Spd, WritesTheSceneThatTheNameStandsFor) {
  ASSERT_EQ(run("spd gears 1 -o g.nff").exit_code, 0);
  const auto written = load_scene((folder_ / "g.nff").string());
  const auto made = make_spd("gears", 1);
  ASSERT_TRUE(written.ok() && made.ok());
  EXPECT_EQ(written->objects, made->objects);
  EXPECT_EQ(written->vertices, made->vertices);
  EXPECT_EQ(written->camera, made->camera);
}

TEST_F(Spd, WithoutASizeItIsThePublishedOne) {
  ASSERT_EQ(run("spd tetra -o t.nff").exit_code, 0);
  EXPECT_EQ(load_scene((folder_ / "t.nff").string())->objects.size(), 4096u);
}

TEST_F(Spd, AnAbsurdSizeIsRefusedWithTheNumberOfObjectsItWouldMake) {
  const Outcome outcome = run("spd tetra 20 -o t.nff");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("objects"), std::string::npos) << outcome.err;
  EXPECT_FALSE(exists("t.nff"));
}

TEST_F(Spd, ADashWritesToStdout) {
  ASSERT_EQ(run("spd tetra 1 -o t.nff").exit_code, 0);
  EXPECT_EQ(run("spd tetra 1 -o -").out, read("t.nff"));
}

}  // namespace
}  // namespace bspview::test
