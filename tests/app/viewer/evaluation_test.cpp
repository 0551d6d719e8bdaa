#include "app/viewer/evaluation.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

Evaluation of(BuiltTree::Origin origin, std::uint64_t primary) {
  Evaluation evaluation;
  evaluation.origin = origin;
  evaluation.rays = RayCounts{.primary = primary};
  return evaluation;
}

TEST(Comparison, KeepsWhatWasKnownBeforeAnEdit) {
  Comparison comparison;
  comparison.update(of(BuiltTree::Origin::build, 1));
  comparison.begin_edit();
  comparison.update(of(BuiltTree::Origin::cut, 2));
  EXPECT_EQ(comparison.before()->rays->primary, 1u);
  comparison.begin_edit();
  EXPECT_EQ(comparison.before()->rays->primary, 2u);
}

TEST(Comparison, ASketchIsNothingToCompareWith) {
  Comparison comparison;
  comparison.update(of(BuiltTree::Origin::build, 1));
  comparison.begin_edit();
  comparison.update(of(BuiltTree::Origin::sketch, 2));
  comparison.begin_edit();
  EXPECT_EQ(comparison.before()->rays->primary, 1u);
}

}  // namespace
}  // namespace bspview
