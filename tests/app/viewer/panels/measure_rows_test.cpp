#include "app/viewer/panels/measure_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bspview {
namespace {

Evaluation some_evaluation() {
  Evaluation evaluation;
  evaluation.view = PictureRequest();
  evaluation.delta = {.n_ls = 1200,
                      .r_etnls = 0.25,
                      .n_adl = 1.5,
                      .n_aoial = 3.0,
                      .n_aoifl = 4.0,
                      .r_fvwv = 0.5,
                      .n_rprt = 10.0,
                      .n_at = 20.0};
  evaluation.lambda.t_cb = Measured{0.05, 0.0, 1};
  evaluation.lambda.t_tt_share = Measured{0.4, 0.012, 5};
  return evaluation;
}

const MeasureRow& row_of(const std::vector<MeasureRow>& rows, std::string_view name) {
  return *std::ranges::find(rows, name, [](const MeasureRow& row) { return row.name; });
}

TEST(MeasureRows, DeltaHasEightComponentsOfWhichOneIsDerived) {
  const std::vector<MeasureRow> rows = delta_rows(some_evaluation(), nullptr);
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(std::ranges::count(rows, true, &MeasureRow::derived), 1);
  EXPECT_TRUE(row_of(rows, "N_AOIAL").derived);
  EXPECT_EQ(row_of(rows, "N_LS").now, "1\u00a0200");
  EXPECT_EQ(row_of(rows, "N_AT").now, "20.00");
  for (const MeasureRow& row : rows) EXPECT_NE(row.meaning.find('='), std::string::npos);
}

TEST(MeasureRows, WhatIsNotDefinedIsADash) {
  Evaluation evaluation = some_evaluation();
  evaluation.delta.n_rprt.reset();
  EXPECT_EQ(row_of(delta_rows(evaluation, nullptr), "N_RPRT").now, "–");
  EXPECT_EQ(row_of(lambda_rows(evaluation, nullptr), "T_TR").now, "–");
}

TEST(MeasureRows, ThePreviousSettingStandsBesideTheCurrentOneWithTheDifference) {
  const Evaluation before = some_evaluation();
  Evaluation now = before;
  now.delta.n_at = 10.0;
  now.lambda.t_cb = Measured{0.06, 0.0, 1};
  const MeasureRow at = row_of(delta_rows(now, &before), "N_AT");
  EXPECT_EQ(at.before, "20.00");
  EXPECT_EQ(at.change, "−50 %");
  EXPECT_GT(at.benefit, 0.0);
  const MeasureRow built = row_of(lambda_rows(now, &before), "T_CB");
  EXPECT_EQ(built.change, "+20 %");
  EXPECT_LT(built.benefit, 0.0);
}

TEST(MeasureRows, CostsOfOtherRaysAreNotCompared) {
  const Evaluation before = some_evaluation();
  Evaluation now = before;
  now.view->camera.from.x += 1.0f;
  now.delta.n_ls = 600;
  now.delta.n_at = 10.0;
  const std::vector<MeasureRow> rows = delta_rows(now, &before);
  EXPECT_EQ(row_of(rows, "N_AT").change, "");
  EXPECT_EQ(row_of(rows, "N_AT").before, "20.00");
  EXPECT_EQ(row_of(rows, "N_LS").change, "−50 %");
}

TEST(MeasureRows, TheTooltipOfTheShareStatesMethodAndSpread) {
  const MeasureRow row = row_of(lambda_rows(some_evaluation(), nullptr), "T_TT_over_T_TR");
  EXPECT_EQ(row.now, "40 ± 1 %");
  EXPECT_NE(row.meaning.find("How T_TT is measured"), std::string::npos);
  EXPECT_NE(row.meaning.find("5 repeats, ± 1.2 %"), std::string::npos);
}

}  // namespace
}  // namespace bspview
