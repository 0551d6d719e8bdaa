#include "core/render/sample_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "tests/support/random.h"

namespace bspview {
namespace {

TEST(SamplePattern, StartsAtTheCentreAndStaysInThePixel) {
  const std::vector<Vec2> pattern = sample_pattern(4096);
  ASSERT_EQ(pattern.size(), 4096u);
  EXPECT_EQ(pattern[0], Vec2(0.5f));
  for (const Vec2 p : pattern) {
    ASSERT_TRUE(p.x >= 0.0f && p.x < 1.0f && p.y >= 0.0f && p.y < 1.0f) << p.x << ' ' << p.y;
  }
}

TEST(SamplePattern, ALongerOneBeginsWithAShorterOne) {
  const std::vector<Vec2> longer = sample_pattern(100);
  for (const int count : {0, 1, 8, 33}) {
    const std::vector<Vec2> shorter = sample_pattern(count);
    EXPECT_TRUE(std::ranges::equal(shorter, std::span(longer).first(shorter.size()))) << count;
  }
}

/// Cells of a grid of `columns` x `rows` that hold a point.
std::size_t filled_cells(std::span<const Vec2> points, int columns, int rows) {
  std::set<std::pair<int, int>> cells;
  for (const Vec2 p : points) {
    cells.emplace(static_cast<int>(p.x * static_cast<float>(columns)),
                  static_cast<int>(p.y * static_cast<float>(rows)));
  }
  return cells.size();
}

TEST(SamplePattern, EveryGroupOfAPowerOfTwoFillsEveryGridOfAsManyCells) {
  const std::vector<Vec2> pattern = sample_pattern(1024);
  for (std::size_t group = 2; group <= 256; group *= 2) {
    for (std::size_t first = 0; first < pattern.size(); first += group) {
      const auto points = std::span(pattern).subspan(first, group);
      for (int columns = 1; columns <= static_cast<int>(group); columns *= 2) {
        ASSERT_EQ(filled_cells(points, columns, static_cast<int>(group) / columns), group)
            << group << " points from " << first << ", " << columns << " columns";
      }
    }
  }
}

/// A line across the pixel, and the share of the pixel on its side where a x + b y < c.
struct Edge {
  double a, b, c;
  bool covers(Vec2 p) const { return a * p.x + b * p.y < c; }
  double area() const {
    double sum = 0.0;
    constexpr int strips = 256;  // the trapezoids of the strips, exact but where the line ends
    for (int i = 0; i < strips; ++i) {
      const double y = (i + 0.5) / strips;
      const double x = (c - b * y) / a;
      sum += a > 0.0 ? std::clamp(x, 0.0, 1.0) : 1.0 - std::clamp(x, 0.0, 1.0);
    }
    return sum / strips;
  }
};

TEST(SamplePattern, EdgesAreAveragedWellByAnyNumberOfSamples) {
  const std::vector<Vec2> pattern = sample_pattern(256);
  test::Random random(7);
  constexpr int edges = 500;
  std::vector<double> squares(pattern.size() + 1, 0.0);
  for (int i = 0; i < edges; ++i) {
    const double angle = random.between(0.0f, 6.2831853f);
    const double x = random.unit(), y = random.unit();
    const Edge edge{std::cos(angle), std::sin(angle), std::cos(angle) * x + std::sin(angle) * y};
    const double area = edge.area();
    int covered = 0;
    for (std::size_t n = 1; n <= pattern.size(); ++n) {
      covered += edge.covers(pattern[n - 1]);
      const double off = covered / static_cast<double>(n) - area;
      squares[n] += off * off;
    }
  }
  for (std::size_t n = 8; n <= pattern.size(); ++n) {
    const double error = std::sqrt(squares[n] / edges);
    EXPECT_LT(error, 0.5 * std::pow(static_cast<double>(n), -0.75)) << n << " samples";
  }
}

}  // namespace
}  // namespace bspview
