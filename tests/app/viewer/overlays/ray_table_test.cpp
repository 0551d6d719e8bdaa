#include "app/viewer/overlays/ray_table.h"

#include <limits>

#include <gtest/gtest.h>

namespace bspview {
namespace {

PathRay sample_ray() {
  PathRay ray;
  ray.object = 7;
  ray.t = 1.3125;
  ray.log.steps = {{.node = 0,
                    .kind = StepKind::both,
                    .axis = 0,
                    .split = 1.25f,
                    .t_split = 1.31f,
                    .t_enter = 0.5f,
                    .t_exit = 1.75f},
                   {.node = 2,
                    .kind = StepKind::near_only,
                    .axis = 2,
                    .split = -3.0f,
                    .t_split = std::numeric_limits<float>::infinity(),
                    .t_enter = 0.5f,
                    .t_exit = 1.31f},
                   {.node = 5,
                    .kind = StepKind::leaf,
                    .t_enter = 0.5f,
                    .t_exit = 1.31f,
                    .first_test = 0,
                    .test_count = 1},
                   {.node = 17,
                    .kind = StepKind::leaf,
                    .t_enter = 1.31f,
                    .t_exit = 1.75f,
                    .first_test = 1,
                    .test_count = 3}};
  ray.log.tests = {{.object = 3},
                   {.object = 4, .hit = true, .t = 1.5},
                   {.object = 7, .hit = true, .t = 1.3125},
                   {.object = 9}};
  return ray;
}

TEST(RayTable, InnerNodesTellPlaneAndChildren) {
  const auto rows = ray_table(sample_ray());
  EXPECT_EQ(rows[0], (RayTableRow{"1", "0", "near, far", "x = 1.25", "1.31", "0.5 to 1.75", ""}));
  EXPECT_EQ(rows[1], (RayTableRow{"2", "2", "near", "z = -3", "never", "0.5 to 1.31", ""}));
}

TEST(RayTable, LeavesTellTheirTestsAndTheNearestHit) {
  const auto rows = ray_table(sample_ray());
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[2], (RayTableRow{"3", "5", "leaf", "", "", "0.5 to 1.31", "1"}));
  EXPECT_EQ(rows[3].tests, "3, hits object 7 at 1.312");
}

TEST(RayTable, ARayWithoutStepsHasNoRows) {
  EXPECT_TRUE(ray_table({}).empty());
}

TEST(RayTable, TitlesTellKindSenderAndFate) {
  PathRay ray = sample_ray();
  EXPECT_EQ(ray_title(ray, 0), "1 eye ray: hits object 7 at t = 1.312");
  ray.kind = RayKind::shadow;
  ray.parent = 0;
  EXPECT_EQ(ray_title(ray, 3), "4 shadow ray of ray 1: is blocked by object 7 at t = 1.312");
  ray.object = no_index;
  EXPECT_EQ(ray_title(ray, 3), "4 shadow ray of ray 1: reaches the light");
  ray.kind = RayKind::refracted;
  EXPECT_EQ(ray_title(ray, 1), "2 refracted ray of ray 1: leaves the scene");
}

TEST(RayTable, TheSummaryCounts) {
  EXPECT_EQ(ray_summary(sample_ray()), "4 steps, 2 leaves, 4 tests");
  PathRay ray;
  ray.log.steps = {{.node = 0, .kind = StepKind::leaf}};
  EXPECT_EQ(ray_summary(ray), "1 step, 1 leaf, 0 tests");
}

}  // namespace
}  // namespace bspview
