#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

class Cast : public Bspeval {
 protected:
  Cast() { write("s.nff", small_scene()); }

  /// What cast writes for `rays`.
  std::string results(const std::string& rays, const std::string& options = "") const {
    write("rays.txt", rays);
    const Outcome outcome = run("cast s.nff --rays rays.txt -o out.txt " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    return read("out.txt");
  }
};

TEST_F(Cast, AnswersOneLineForEachRayInOrder) {
  EXPECT_EQ(results("0 0 10 0 0 -1   # the sphere\n"
                    "\n"
                    "# then the triangle, twice, and nothing\n"
                    "2 -3 10 0 0 -1\n"
                    "2 -3 10 0 0 -0.5\n"
                    "9 9 10 0 0 -1\n"),
            "1 6\n0 10\n0 20\n-1 inf\n");
}

TEST_F(Cast, TheIntervalOfARayIsOpen) {
  EXPECT_EQ(results("0 0 10 0 0 -1 0 6\n0 0 10 0 0 -1 0 6.5\n0 0 10 0 0 -1 6 7\n"
                    "0 0 10 0 0 -1 7 20\n0 0 10 0 0 -1 8.5 20\n0 0 10 0 0 -1 5 4\n"),
            "-1 inf\n1 6\n-1 inf\n1 8\n0 10\n-1 inf\n");
}

TEST_F(Cast, OcclusionIsOneOrZero) {
  EXPECT_EQ(results("0 0 10 0 0 -1\n9 9 10 0 0 -1\n0 0 10 0 0 -1 0 1\n", "--any"), "1\n0\n0\n");
}

TEST_F(Cast, WhatCannotHitAnythingMisses) {
  EXPECT_EQ(results("nan 0 10 0 0 -1\n0 0 10 0 0 0\n0 0 10 0 0 -inf\ninf 0 10 0 0 -1\n"
                    "0 0 10 0 0 -1 nan 9\n0 0 10 0 0 -1 0 nan\n"),
            "-1 inf\n-1 inf\n-1 inf\n-1 inf\n-1 inf\n-1 inf\n");
}

TEST_F(Cast, DirectionsOfAnyLengthCount) {
  EXPECT_EQ(results("0 0 10 0 0 -1e-30\n0 0 10 0 0 -1e30\n2 -3 10 0 0 -1e-40\n"),
            "1 5.99999998e+30\n1 5.99999991e-30\n0 1.00000539e+41\n");
}

TEST_F(Cast, EveryBuilderAndTraversalGivesTheSameResults) {
  std::string rays;
  for (int i = 0; i < 300; ++i) {
    rays += std::to_string(i * 0.05 - 7.0) + " " + std::to_string(i % 17 * 0.7 - 5.0) +
            " 20 0.1 -0.05 -3\n";
  }
  const std::string expected = results(rays, "--builder naive --threads 1");
  for (const char* builder : {"median", "median-longest", "object-median", "mb", "sah"}) {
    EXPECT_EQ(results(rays, std::string("--builder ") + builder), expected) << builder;
  }
  for (const char* traversal : {"sung-shirley", "havran", "robust"}) {
    EXPECT_EQ(results(rays, std::string("--traversal ") + traversal), expected) << traversal;
  }
}

TEST_F(Cast, NoRaysGiveNoResults) {
  EXPECT_EQ(results("# nothing\n"), "");
}

TEST_F(Cast, ALineThatIsNoRayIsNamedAndNothingIsWritten) {
  write("rays.txt", "0 0 10 0 0 -1\n\n0 0 10 0 0\n");
  write("out.txt", "as before");
  const Outcome outcome = run("cast s.nff --rays rays.txt -o out.txt");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "bspeval: rays.txt:3: a ray has 6 or 8 numbers, not 5\n");
  EXPECT_EQ(read("out.txt"), "as before");
}

TEST_F(Cast, RepeatsPrintTheirMedianRate) {
  write("rays.txt", "0 0 10 0 0 -1\n");
  const Outcome outcome = run("cast s.nff --rays rays.txt -o - --repeat 3");
  EXPECT_EQ(outcome.out, "1 6\n");
  EXPECT_EQ(outcome.err.rfind("median ", 0), 0u);
  EXPECT_NE(outcome.err.find("Mrays/s of 3 repeats"), std::string::npos);
  EXPECT_EQ(run("cast s.nff --rays rays.txt -o -").err, "");
}

TEST_F(Cast, RaysCanComeThroughAPipe) {
  EXPECT_EQ(run("cast s.nff --rays - -o - < s.nff").err,
            "bspeval: standard input:1: 'b' is no number\n");
}

}  // namespace
}  // namespace bspview::test
