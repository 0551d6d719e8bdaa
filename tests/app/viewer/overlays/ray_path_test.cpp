#include "app/viewer/overlays/ray_path.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// The rays of the first pixel of the diagonal that shows something.
std::vector<PathRay> rays_of_a_hit(const Scene& scene, const Tree& tree) {
  std::vector<PathRay> rays;
  for (float i = 0.5f; i < 200.0f; i += 5.0f) {
    rays = trace_pixel({scene, tree}, scene.camera, {.width = 200, .height = 200}, {i, i});
    if (rays[0].object != no_index) break;
  }
  return rays;
}

class RayPath : public testing::Test {
 protected:
  RayPath()
      : scene_(test::random_scene(60, 4)),
        tree_(*build_scene_tree(scene_, {})),
        cells_(tree_),
        transform_(scene_.camera, 200, 200),
        rays_(rays_of_a_hit(scene_, tree_)) {}

  LineList lines(RaySelection selection) const {
    return ray_path_lines({scene_, cells_, transform_}, rays_, selection);
  }

  Scene scene_;
  Tree tree_;
  NodeCells cells_;
  ScreenTransform transform_;
  std::vector<PathRay> rays_;
};

bool has_line(const LineList& lines, Vec3 from, Vec3 to) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const Line& line) { return line.from == from && line.to == to; });
}

TEST_F(RayPath, ShowsTheCellsOfEveryVisitedLeaf) {
  ASSERT_FALSE(rays_.empty());
  for (int i = 0; i < static_cast<int>(rays_.size()); ++i) {
    const LineList path = lines({.ray = i});
    for (const RayStep& step : rays_[i].log.steps) {
      if (step.kind != StepKind::leaf) continue;
      LineList box;
      add_box(box, cells_.cell(step.node), {});
      for (const Line& edge : box) EXPECT_TRUE(has_line(path, edge.from, edge.to));
    }
  }
}

TEST_F(RayPath, EndsAtTheHit) {
  const PathRay& ray = rays_[0];
  ASSERT_NE(ray.object, no_index);
  EXPECT_TRUE(
      has_line(lines({}), ray.ray.at(ray.ray.t_min), ray.ray.at(static_cast<float>(ray.t))));
}

TEST_F(RayPath, CellsFollowEachOtherAlongTheRay) {
  // What the path draws: entry and exit of a leaf lie on the surface of its cell.
  const PathRay& ray = rays_[0];
  for (const RayStep& step : ray.log.steps) {
    if (step.kind != StepKind::leaf) continue;
    const Aabb cell = cells_.cell(step.node);
    const float slack = 1e-4f * (1.0f + glm::length(ray.ray.origin));
    const Aabb grown{cell.lo - slack, cell.hi + slack};
    EXPECT_TRUE(grown.contains(ray.ray.at(step.t_enter)));
    EXPECT_TRUE(grown.contains(ray.ray.at(step.t_exit)));
  }
}

TEST_F(RayPath, TheHighlightedStepStandsOut) {
  const LineList path = lines({.ray = 0, .step = 0}), without = lines({.ray = 0});
  EXPECT_GT(path.size(), without.size());
  LineList box;
  add_box(box, tree_.box, {});
  const auto highlighted = std::find_if(path.begin(), path.end(), [&](const Line& line) {
    return line.from == box[0].from && line.to == box[0].to && line.width > 2.5f;
  });
  EXPECT_NE(highlighted, path.end());
}

TEST_F(RayPath, OtherRaysOfThePixelStayVisible) {
  EXPECT_EQ(lines({.ray = -1}).size(), rays_.size());
  EXPECT_EQ(lines({.ray = 1000, .step = 3}).size(), rays_.size());
}

TEST_F(RayPath, AStepThatIsNoneHighlightsNothing) {
  EXPECT_EQ(lines({.ray = 0, .step = 100000}).size(), lines({.ray = 0}).size());
}

TEST_F(RayPath, NoRaysMakeNoLines) {
  EXPECT_TRUE(ray_path_lines({scene_, cells_, transform_}, {}, {}).empty());
}

TEST_F(RayPath, ARayThatMissesEndsBehindTheScene) {
  PathRay ray;
  ray.ray = {tree_.box.hi + 5.0f, {1.0f, 0.5f, 0.25f}};
  const LineList path = ray_path_lines({scene_, cells_, transform_}, {&ray, 1}, {});
  for (const Line& line : path) {
    EXPECT_TRUE(std::isfinite(glm::length(line.to)));
    EXPECT_GT(glm::length(line.to - line.from), 1.0f);
  }
}

}  // namespace
}  // namespace bspview
