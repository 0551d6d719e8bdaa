// The checks of the stress test can fail: each goes red on a variant that breaks what it guards,
// and stays green on ours in the same trials.

#include "tests/mutants/mutants.h"

#include <gtest/gtest.h>

#include "core/eval/stress/stress.h"

namespace bspview::test {
namespace {

struct Case {
  const char* name;
  const char* check;
  std::int64_t trials;
  stress::Subject mutant;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.name << " " << test.check;
}

std::int64_t failures_of(const Case& test, const stress::Subject& subject) {
  const auto rows = stress::run({.trials = test.trials, .ids = {test.check}}, {}, subject);
  EXPECT_TRUE(rows.ok());
  EXPECT_EQ(rows->size(), 1u);
  return rows->front().failures;
}

class Mutant : public ::testing::TestWithParam<Case> {};

TEST_P(Mutant, GoesRedAndOursStaysGreen) {
  const std::int64_t failures = failures_of(GetParam(), GetParam().mutant);
  EXPECT_GT(failures, 0);
  RecordProperty("failures", std::to_string(failures));
  EXPECT_EQ(failures_of(GetParam(), stress::default_subject()), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Stress, Mutant,
    ::testing::Values(Case{"ContractedEdge", "T04", 1000, contracted_woop()},
                      Case{"ContractedWoop", "T05", 20'000, contracted_woop()},
                      Case{"SingleDistances", "T06", 20'000, single_distances()},
                      Case{"SingleDistances", "T08", 200, single_distances()},
                      Case{"HitsInsideCells", "T07", 1000, hits_inside_cells()},
                      Case{"NoOffset", "T14", 200, no_offset()},
                      Case{"NoOffset", "T15", 1000, no_offset()},
                      Case{"FloatTriangles", "T01", 2000, float_triangles()},
                      Case{"FloatTriangles", "T02", 2000, float_triangles()},
                      Case{"FloatTriangles", "T05", 2000, float_triangles()},
                      Case{"FloatTriangles", "T17", 20, float_triangles()},
                      Case{"FloatQuadrics", "T17", 20, float_quadrics()},
                      Case{"SingleDistances", "T17", 20, single_distances()},
                      Case{"FloatQuadrics", "T19", 1000, float_quadrics()},
                      Case{"NaiveSlabs", "T08", 200, naive_slabs()},
                      Case{"BoxesRoundedInwards", "T10", 1000, boxes_rounded_inwards()},
                      Case{"BoxesRoundedInwards", "T16", 1000, boxes_rounded_inwards()},
                      Case{"ShortSightedOcclusion", "T20", 500, short_sighted_occlusion()},
                      Case{"SungShirley", "T08", 200, published(Traversal::sung_shirley)},
                      Case{"Havran", "T08", 200, published(Traversal::havran)}),
    [](const auto& test) { return std::string(test.param.name) + test.param.check; });

}  // namespace
}  // namespace bspview::test
