#include "app/viewer/overlays/line_raster.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace bspview {
namespace {

constexpr int width = 200, height = 150;

/// Looks along -z from (0, 0, 10): x to the right, y up.
Camera camera() {
  Camera camera;
  camera.from = {0.0f, 0.0f, 10.0f};
  return camera;
}

LineView view() {
  return {.camera = camera(), .width = width, .height = height, .distance = {}};
}

Layer draw(const LineList& lines, const LineView& line_view) {
  return draw_lines(lines, line_view).value();
}

std::uint32_t alpha_at(const Layer& layer, int x, int y) {
  return layer.pixels[y * layer.width + x] >> 24;
}

/// Opacity of the whole layer, in opaque pixels.
double ink(const Layer& layer) {
  double sum = 0.0;
  for (const std::uint32_t pixel : layer.pixels) sum += (pixel >> 24) / 255.0;
  return sum;
}

/// The point at depth `depth` under pixel coordinates (x, y).
Vec3 point_at(float x, float y, float depth) {
  return PrimaryRays(camera(), width, height).ray(x, y).at(depth);
}

LineList random_lines(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-8.0f, 12.0f), thickness(0.5f, 4.0f);
  LineList lines;
  for (int i = 0; i < count; ++i) {
    const auto point = [&] {
      const float x = coordinate(random), y = coordinate(random);
      return Vec3(x, y, coordinate(random));
    };
    const Vec3 from = point(), to = point();
    lines.push_back({from, to, static_cast<std::uint32_t>(random()), thickness(random)});
  }
  return lines;
}

TEST(LineRaster, ALineFillsThePixelsWhoseMiddlesItRunsThrough) {
  const LineList lines{{point_at(20.0f, 40.5f, 5.0f), point_at(90.0f, 40.5f, 8.0f)}};
  const Layer layer = draw(lines, view());
  for (int x = 21; x < 89; ++x) {
    EXPECT_GE(alpha_at(layer, x, 40), 253u) << x;
    EXPECT_LE(alpha_at(layer, x, 39), 2u) << x;
    EXPECT_LE(alpha_at(layer, x, 41), 2u) << x;
  }
  EXPECT_EQ(alpha_at(layer, 18, 40), 0u);
  EXPECT_EQ(alpha_at(layer, 92, 40), 0u);
}

TEST(LineRaster, AVerticalLineFillsItsColumn) {
  const LineList lines{{point_at(70.5f, 10.0f, 5.0f), point_at(70.5f, 140.0f, 5.0f)}};
  const Layer layer = draw(lines, view());
  for (int y = 11; y < 139; ++y) EXPECT_GE(alpha_at(layer, 70, y), 253u) << y;
}

TEST(LineRaster, TheInkOfALineIsItsLengthTimesItsWidth) {
  for (const float thickness : {0.5f, 1.0f, 2.0f, 4.0f, 8.0f}) {
    for (const Vec2 to : {Vec2(180.0f, 50.0f), Vec2(110.0f, 140.0f), Vec2(60.0f, 10.0f)}) {
      const Vec2 from(50.0f, 50.0f);
      LineList lines{{point_at(from.x, from.y, 5.0f), point_at(to.x, to.y, 5.0f)}};
      lines[0].width = thickness;
      const double area = thickness * glm::length(to - from);
      EXPECT_NEAR(ink(draw(lines, view())), area, 0.02 * area) << thickness << ' ' << to.x;
    }
  }
}

TEST(LineRaster, ASurfaceInFrontDimsTheHiddenHalf) {
  std::vector<float> distance(width * height, std::numeric_limits<float>::infinity());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width / 2; ++x) distance[y * width + x] = 4.0f;
  }
  const LineList lines{{point_at(20.0f, 40.5f, 5.0f), point_at(180.0f, 40.5f, 5.0f)}};
  LineView line_view = view();
  line_view.distance = distance;
  line_view.hidden_alpha = 0.25f;
  const Layer layer = draw(lines, line_view);
  for (int x = 22; x < 99; ++x) EXPECT_NEAR(alpha_at(layer, x, 40), 64.0, 2.0) << x;
  for (int x = 100; x < 178; ++x) EXPECT_GE(alpha_at(layer, x, 40), 253u) << x;
}

TEST(LineRaster, DepthIsComparedAlongASlantedLine) {
  // The line goes from depth 2 to depth 18; the surface stands at 6, where the ray's t is 6, too.
  const std::vector<float> distance(width * height, 6.0f);
  const Vec3 from = point_at(20.0f, 75.5f, 2.0f), to = point_at(180.0f, 75.5f, 18.0f);
  LineView line_view = view();
  line_view.distance = distance;
  const Layer layer = draw({{from, to}}, line_view);
  const Vec3 crossing = PrimaryRays(camera(), width, height).project(from + 0.25f * (to - from));
  ASSERT_NEAR(crossing.z, 6.0f, 1e-4f);
  for (int x = 22; x < crossing.x - 1.0f; ++x) EXPECT_GE(alpha_at(layer, x, 75), 253u) << x;
  // A few pixels behind the surface are still seen (four pixel sides), then none.
  const int behind = static_cast<int>(crossing.x) + 6;
  for (int x = behind; x < 178; ++x) EXPECT_LE(alpha_at(layer, x, 75), 66u) << x;
}

TEST(LineRaster, ALineOnAPlaneSeenAtASlantIsWhole) {
  // The floor y = -1, whose distance is that of its own rays.
  const PrimaryRays rays(camera(), width, height);
  std::vector<float> distance(width * height, std::numeric_limits<float>::infinity());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Ray ray = rays.ray(x + 0.5f, y + 0.5f);
      if (ray.direction.y < 0.0f) distance[y * width + x] = -1.0f / ray.direction.y;
    }
  }
  LineView line_view = view();
  line_view.distance = distance;
  const LineList lines{{{-1.0f, -1.0f, 6.0f}, {1.0f, -1.0f, 2.0f}}};
  EXPECT_EQ(draw(lines, line_view), draw(lines, view()));
}

TEST(LineRaster, LinesThroughTheEyesPlaneAreCutThere) {
  const LineList lines{{{0.0f, -0.5f, 5.0f}, {0.0f, -0.5f, 50.0f}}};
  const Layer layer = draw(lines, view());
  EXPECT_GT(alpha_at(layer, width / 2, height - 1), 100u);
  EXPECT_EQ(alpha_at(layer, width / 2, height / 2 - 2), 0u);
}

TEST(LineRaster, WhatCannotBeSeenLeavesNothing) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const LineList lines{
      {{0.0f, 0.0f, 11.0f}, {1.0f, 0.0f, 20.0f}},  // behind the eye
      {{1e9f, 0.0f, 0.0f}, {1e9f, 5.0f, 0.0f}},    // beside the picture
      {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}},    // a point
      {{nan, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}},     // no line
      {{-infinity, 0.0f, 0.0f}, {infinity, 0.0f, 0.0f}},
      {{0.0f, 0.0f, 10.0f}, {0.0f, 0.0f, 10.0f}},  // the eye
  };
  EXPECT_EQ(draw(lines, view()), Layer(width, height));
}

TEST(LineRaster, HugeLinesCrossThePictureWhereTheyShould) {
  const LineList lines{{{-1e7f, 0.0f, 0.0f}, {1e7f, 0.0f, 0.0f}}};
  const Layer layer = draw(lines, view());
  for (int x = 0; x < width; ++x) {
    EXPECT_NEAR(alpha_at(layer, x, 74) + alpha_at(layer, x, 75), 255.0, 2.0) << x;
  }
}

TEST(LineRaster, TheMoreOpaqueLineWinsAndTheLaterAmongEquals) {
  const Vec3 left = point_at(20.0f, 40.5f, 5.0f), right = point_at(180.0f, 40.5f, 5.0f);
  const Line faint{left, right, 0x400000ffu}, red{left, right, 0xff0000ffu};
  const Line green{left, right, 0xff00ff00u};
  const auto pixel = [](const LineList& lines) {
    return draw(lines, view()).pixels[40 * width + 100];
  };
  EXPECT_EQ(pixel({red, faint}), pixel({red}));
  EXPECT_EQ(pixel({faint, red}), pixel({red}));
  EXPECT_EQ(pixel({red, green}), pixel({green}));
  EXPECT_EQ(pixel({faint, faint, faint}), pixel({faint}));
}

TEST(LineRaster, TheLayerIsTheSameForAnyNumberOfThreads) {
  const LineList lines = random_lines(20000, 7);
  std::vector<float> distance(width * height);
  for (std::size_t i = 0; i < distance.size(); ++i) distance[i] = static_cast<float>(i % 23);
  LineView line_view = view();
  line_view.distance = distance;
  line_view.threads = 1;
  const Layer expected = draw(lines, line_view);
  EXPECT_GT(ink(expected), 1000.0);
  for (const int threads : {2, 3, 8, 0}) {
    line_view.threads = threads;
    EXPECT_EQ(draw(lines, line_view), expected) << threads;
  }
}

TEST(LineRaster, TilesLeaveNoSeams) {
  // The same line in a picture whose tiles end elsewhere: the lower right part of a larger one.
  const LineList lines{{point_at(3.0f, 5.0f, 5.0f), point_at(197.0f, 131.0f, 9.0f)},
                       {point_at(190.0f, 3.0f, 5.0f), point_at(5.0f, 147.0f, 9.0f)}};
  const Layer layer = draw(lines, view());
  for (int x = 10; x < 185; ++x) {
    double column = 0.0;
    for (int y = 0; y < height; ++y) column += alpha_at(layer, x, y) / 255.0;
    EXPECT_GT(column, 1.1) << x;
    EXPECT_LT(column, 2.7) << x;
  }
}

TEST(LineRaster, ComponentsArePremultiplied) {
  const Layer layer = draw(random_lines(2000, 3), view());
  for (const std::uint32_t pixel : layer.pixels) {
    const std::uint32_t alpha = pixel >> 24;
    ASSERT_LE(pixel & 255u, alpha);
    ASSERT_LE(pixel >> 8 & 255u, alpha);
    ASSERT_LE(pixel >> 16 & 255u, alpha);
  }
}

TEST(LineRaster, AStopLeavesNoLayer) {
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(draw_lines(random_lines(10, 1), view(), source.get_token()).has_value());
}

TEST(LineRaster, APictureWithoutPixelsIsAnEmptyLayer) {
  LineView line_view = view();
  line_view.width = 0;
  EXPECT_EQ(draw(random_lines(10, 1), line_view).pixels.size(), 0u);
}

}  // namespace
}  // namespace bspview
