#include "core/eval/ray_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace bspview {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

std::string error_of(std::string_view text) {
  const Result<std::vector<Ray>> rays = parse_rays(text, "r.txt");
  return rays.ok() ? "" : rays.error().message;
}

TEST(RaySet, ReadsSixOrEightNumbersALine) {
  const auto rays = parse_rays("1 2 3 4 5 6\n-1 +2 .5 1e2 -1E-3 0 0.25 7\n", "r.txt");
  ASSERT_TRUE(rays.ok());
  const std::vector<Ray> expected{{{1, 2, 3}, {4, 5, 6}},
                                  {{-1, 2, 0.5f}, {100, -0.001f, 0}, 0.25f, 7}};
  EXPECT_EQ(*rays, expected);
}

TEST(RaySet, CommentsBlankLinesAndLineEndsOfOtherSystemsAreNoRays) {
  const auto rays = parse_rays("# head\r\n\r\n  \t\n1 2 3\t4 5 6 # tail\r\n\n0 0 0 0 0 1", "r.txt");
  ASSERT_TRUE(rays.ok());
  EXPECT_EQ(rays->size(), 2u);
  EXPECT_TRUE(parse_rays("", "r.txt")->empty());
}

TEST(RaySet, ALineThatIsNoRayIsAnErrorWithItsNumber) {
  EXPECT_EQ(error_of("0 0 0 0 0 1\n# c\n1 2 3 4 5\n"), "r.txt:3: a ray has 6 or 8 numbers, not 5");
  EXPECT_EQ(error_of("1 2 3 4 5 6 7"), "r.txt:1: a ray has 6 or 8 numbers, not 7");
  EXPECT_EQ(error_of("1 2 3 4 5 6 7 8 9"), "r.txt:1: a ray has 6 or 8 numbers, not 9");
  EXPECT_EQ(error_of("\n1 2 x 4 5 6"), "r.txt:2: 'x' is no number");
  for (const char* word :
       {"1.0f", "1,5", "--1", "+-1", "-", "0x", "1e", "1..2", "0x1.8p", "\"1\""}) {
    EXPECT_EQ(error_of(std::string("1 2 3 4 5 ") + word),
              std::string("r.txt:1: '") + word + "' is no number");
  }
}

TEST(RaySet, ReadsHexadecimalNumbersAndTheValuesThatAreNoNumbers) {
  const auto rays = parse_rays("0x1.8p1 -0X1p-149 inf -inf nan 1", "r.txt");
  ASSERT_TRUE(rays.ok());
  const Ray& ray = rays->front();
  EXPECT_EQ(ray.origin, Vec3(3.0f, -0x1p-149f, infinity));
  EXPECT_EQ(ray.direction.x, -infinity);
  EXPECT_TRUE(std::isnan(ray.direction.y));
}

TEST(RaySet, NumbersBeyondTheFloatsBecomeInfinityOrZero) {
  const auto rays = parse_rays("1e39 -1e39 1e400 1e-50 -1e-400 1e-45", "r.txt");
  ASSERT_TRUE(rays.ok());
  EXPECT_EQ(rays->front().origin, Vec3(infinity, -infinity, infinity));
  EXPECT_EQ(rays->front().direction, Vec3(0.0f, 0.0f, 0x1p-149f));
  const auto hexadecimal =
      parse_rays("0x1p200 -0x1p-200 0." + std::string(60, '0') + "1 0 0 1", "");
  ASSERT_TRUE(hexadecimal.ok());
  EXPECT_EQ(hexadecimal->front().origin, Vec3(infinity, 0.0f, 0.0f));
}

TEST(RaySet, NineDigitsGiveEveryFloatBack) {
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    const std::string text = format_results(std::vector<RayResult>{{0, value}});
    const auto rays = parse_rays("0 0 0 0 0 " + text.substr(2), "r.txt");
    ASSERT_TRUE(rays.ok()) << text;
    ASSERT_EQ(rays->front().direction.z, value) << text;
  }
}

TEST(RaySet, ResultsAreWrittenAsPrintfWritesThem) {
  const std::vector<RayResult> results{{0, 1.5}, {}, {7381, 0.1}, {12, 1e20}, {3, 1e-7}};
  std::string expected;
  for (const RayResult& result : results) {
    char line[64];
    std::snprintf(line, sizeof line, "%d %.9g\n", static_cast<int>(result.object), result.t);
    expected += line;
  }
  EXPECT_EQ(format_results(results), expected);
  EXPECT_EQ(format_results(std::vector<RayResult>(1)), "-1 inf\n");
  EXPECT_EQ(format_occlusion(results), "1\n0\n1\n1\n1\n");
}

TEST(RaySet, ARayThatStartsBehindItsOriginIsRefused) {
  const auto rays = parse_rays("0 0 0 0 0 1 0 5\n0 0 0 0 0 1 -1 5\n", "rays.txt");
  ASSERT_FALSE(rays.ok());
  EXPECT_EQ(rays.error().message, "rays.txt:2: tmin is -1: rays do not start behind their origin");
}

}  // namespace
}  // namespace bspview
