#include "core/render/render.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/render/record.h"
#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// A scene with its tree.
struct Built {
  Scene scene;
  Tree tree;
  World world() const { return {scene, tree}; }
};

Built random_world(int objects, std::uint64_t seed) {
  Built built{test::random_scene(objects, seed), {}};
  BuildParams params;
  auto tree = build_scene_tree(built.scene, params);
  EXPECT_TRUE(tree.ok());
  built.tree = std::move(*tree);
  return built;
}

RenderParams small_picture() {
  RenderParams params;
  params.width = 70;  // not a multiple of the tile
  params.height = 50;
  return params;
}

TEST(Render, PictureAndCountsDoNotDependOnTheNumberOfThreads) {
  const Built built = random_world(300, 41);
  for (const bool spd_rules : {false, true}) {
    RenderParams params = small_picture();
    params.spd_rules = spd_rules;
    params.samples = 3;
    params.threads = 1;
    const auto one = render_counted(built.world(), built.scene.camera, params);
    ASSERT_TRUE(one.ok());
    for (const int threads : {2, 3, 8}) {
      params.threads = threads;
      const auto many = render_counted(built.world(), built.scene.camera, params);
      ASSERT_TRUE(many.ok());
      EXPECT_EQ(many->image, one->image) << threads;
      EXPECT_EQ(many->counts, one->counts) << threads;
    }
  }
}

TEST(Render, CountingRecordingAndReferenceShowTheSamePicture) {
  const Built built = random_world(200, 42);
  const RenderParams params = small_picture();
  const auto plain = render_image(built.world(), built.scene.camera, params);
  const auto counted = render_counted(built.world(), built.scene.camera, params);
  const auto reference = render_reference(built.scene, built.scene.camera, params);
  ASSERT_TRUE(plain.ok() && counted.ok() && reference.ok());
  EXPECT_EQ(counted->image, *plain);
  int different = 0;
  for (std::size_t i = 0; i < plain->pixels.size(); ++i) {
    different +=
        glm::any(glm::greaterThan(glm::abs(plain->pixels[i] - reference->pixels[i]), Vec3(1e-4f)));
  }
  // Where a ray meets an edge, or a mirror of a mirror, double may decide otherwise.
  EXPECT_LE(different, 3);
}

TEST(Render, EveryTreeShowsThePictureOfTheNaiveMethod) {
  const Scene scene = test::random_scene(200, 43);
  const RenderParams params = small_picture();
  BuildParams naive;
  naive.builder = Builder::naive;
  const auto flat = build_scene_tree(scene, naive);
  const auto expected = render_image({scene, *flat}, scene.camera, params);
  for (const Builder builder : {Builder::median, Builder::median_longest, Builder::object_median,
                                Builder::mb, Builder::sah, Builder::sah_binned}) {
    BuildParams build;
    build.builder = builder;
    build.max_depth = 12;
    const auto tree = build_scene_tree(scene, build);
    const auto image = render_image({scene, *tree}, scene.camera, params);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(*image, *expected) << name_of(builder);
  }
}

TEST(Render, ConvergedProgressivePictureIsTheWholePicture) {
  const Built built = random_world(200, 44);
  RenderParams params = small_picture();
  params.samples = 4;
  const auto whole = render_counted(built.world(), built.scene.camera, params);
  Frame last;
  std::vector<int> passes;
  render_progressive(built.world(), built.scene.camera, params, {}, [&](const Frame& frame) {
    passes.push_back(frame.pass);
    last = frame;
  });
  EXPECT_EQ(passes, (std::vector<int>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(last.pass, last.pass_count);
  EXPECT_EQ(last.color, whole->image.pixels);
}

TEST(Render, CountsOfAProgressivePictureAreThoseOfOneRayAPixel) {
  const Built built = random_world(200, 45);
  RenderParams params = small_picture();
  const auto single = render_counted(built.world(), built.scene.camera, params);
  params.samples = 2;
  render_progressive(built.world(), built.scene.camera, params, {}, [&](const Frame& frame) {
    EXPECT_EQ(frame.counted, frame.pass >= 4);
    if (frame.counted) {
      EXPECT_EQ(frame.counts, single->counts);
    }
  });
}

TEST(Render, AProgressivePictureCanLookFirst) {
  const Built built = random_world(200, 45);
  RenderParams params = small_picture();
  params.samples = 4;
  std::vector<Frame> frames;
  int asked = 0;
  const auto fast = [&] {
    EXPECT_TRUE(frames.back().counted) << "before it is needed";
    ++asked;
    return built.world();
  };
  render_progressive({.counted = built.world(), .fast = fast, .looks_first = true},
                     built.scene.camera, params, {},
                     [&](const Frame& frame) { frames.push_back(frame); });
  ASSERT_EQ(frames.size(), 8u);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(frames[0].pass, 0);
  EXPECT_FALSE(frames[0].counted);
  EXPECT_EQ(frames[0].counts, RayCounts());
  EXPECT_EQ(frames[0].leaf, frames[1].leaf);
  EXPECT_EQ(frames[0].distance, frames[1].distance);
  const auto whole = render_counted(built.world(), built.scene.camera, params);
  EXPECT_EQ(frames.back().color, whole->image.pixels);
}

TEST(Render, EveryPassOfAProgressivePictureFillsEveryPixel) {
  Built built = random_world(200, 46);
  built.scene.background = Vec3(-1.0f);  // a colour that nothing else has
  RenderParams params = small_picture();
  std::vector<Vec3> first;
  render_progressive(built.world(), built.scene.camera, params, {}, [&](const Frame& frame) {
    if (first.empty()) first = frame.color;
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
      ASSERT_EQ(frame.color[i] == Vec3(-1.0f), frame.object[i] == no_index);
      ASSERT_EQ(std::isinf(frame.distance[i]), frame.object[i] == no_index);
      ASSERT_EQ(frame.leaf[i] == no_leaf, frame.object[i] == no_index);
    }
  });
  EXPECT_EQ(first[0], first[7]);  // one ray coloured the whole block
}

TEST(Render, StopEndsItWithoutAPicture) {
  const Built built = random_world(200, 47);
  RenderParams params = small_picture();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(
      render_image(built.world(), built.scene.camera, params, stop.get_token()).error().message,
      "stopped");
  int published = 0;
  std::stop_source later;
  render_progressive(built.world(), built.scene.camera, params, later.get_token(),
                     [&](const Frame&) {
                       ++published;
                       later.request_stop();
                     });
  EXPECT_EQ(published, 1);
}

TEST(Render, RaysOfThePixelsAreTheRaysOfThePicture) {
  const Built built = random_world(200, 48);
  const RenderParams params = small_picture();
  const auto counted = render_counted(built.world(), built.scene.camera, params);
  RayCounts sum;
  for (int y = 0; y < params.height; ++y) {
    for (int x = 0; x < params.width; ++x) {
      const auto rays =
          trace_pixel(built.world(), built.scene.camera, params, {x + 0.5f, y + 0.5f});
      for (const PathRay& path : rays) {
        sum.add_ray(path.kind, path.object != no_index);
        sum.tests += path.log.tests.size();
        for (const RayStep& step : path.log.steps) {
          ++(step.kind == StepKind::leaf ? sum.nodes_leaf : sum.nodes_inner);
        }
      }
    }
  }
  EXPECT_EQ(sum, counted->counts);
}

TEST(Render, ParentsOfAPathRayAreWhereItStarts) {
  const Built built = random_world(200, 49);
  const RenderParams params = small_picture();
  int children = 0;
  for (int x = 0; x < params.width; ++x) {
    const auto rays = trace_pixel(built.world(), built.scene.camera, params, {x + 0.5f, 25.5f});
    ASSERT_EQ(rays[0].parent, -1);
    for (std::size_t i = 1; i < rays.size(); ++i) {
      ASSERT_GE(rays[i].parent, 0);
      ASSERT_LT(rays[i].parent, static_cast<int>(i));
      const PathRay& parent = rays[static_cast<std::size_t>(rays[i].parent)];
      ASSERT_EQ(rays[i].level, parent.level + 1);
      const Vec3 start = parent.ray.at(static_cast<float>(parent.t));
      ASSERT_NEAR(glm::distance(start, rays[i].ray.origin), 0.0f, 1e-5f);
      ++children;
    }
  }
  EXPECT_GT(children, 50);
}

TEST(Render, RecordedRaysAreReplayedOverTheSameNumberOfThem) {
  const Built built = random_world(200, 50);
  const RenderParams params = small_picture();
  const auto counted = render_counted(built.world(), built.scene.camera, params);
  const auto rays = record_rays(built.world(), built.scene.camera, params);
  ASSERT_TRUE(rays.ok());
  EXPECT_EQ(rays->size(), counted->counts.all());
  std::uint64_t leaves = 0;
  for (const RecordedRay& ray : *rays) leaves += ray.leaves;
  EXPECT_EQ(leaves, counted->counts.nodes_leaf);
}

TEST(Render, NoRayIsSentWhereItsColourCannotCount) {
  Scene scene = test::cube_grid(2, Vec3(0.0f));
  scene.materials = {{Vec3(1.0f), 0.0f, 0.0f, 0.0f, 0.0f, 1.0f}};  // neither diffuse nor shiny
  const auto tree = build_scene_tree(scene, {});
  const auto black = render_counted({scene, *tree}, scene.camera, small_picture());
  EXPECT_GT(black->counts.primary_hits, 0u);
  EXPECT_EQ(black->counts.shadow, 0u);
  EXPECT_EQ(black->counts.secondary(), 0u);
  scene.materials[0].diffuse = 1.0f;
  scene.lights = {{Vec3(0.0f), Vec3(1.0f)}};  // inside: every visible side faces away
  const auto unlit = render_counted({scene, *tree}, scene.camera, small_picture());
  EXPECT_EQ(unlit->counts.shadow, 0u);
}

TEST(Render, MaximalRayDepthBoundsTheLevels) {
  Built built = random_world(100, 51);
  for (Material& material : built.scene.materials) material.specular = 0.5f;
  RenderParams params = small_picture();
  params.max_ray_depth = 1;
  EXPECT_EQ(render_counted(built.world(), built.scene.camera, params)->counts.secondary(), 0u);
  params.max_ray_depth = 3;
  for (const PathRay& path :
       trace_pixel(built.world(), built.scene.camera, params, {35.5f, 25.5f})) {
    EXPECT_LE(path.level, path.kind == RayKind::shadow ? 4 : 3);
  }
}

}  // namespace
}  // namespace bspview
