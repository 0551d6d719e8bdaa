#pragma once

#include <string>
#include <vector>

#include "app/viewer/evaluation.h"

namespace bspview {

/// One component of Delta or Lambda as the panel shows it.
struct MeasureRow {
  const char* name;  ///< as in JSON, N_LS
  const char* base;  ///< symbol: N with the subscript LS
  const char* index;
  std::string meaning;   ///< a sentence, then the formula on a line of its own
  std::string now;       ///< "–": not defined or not known yet
  std::string before;    ///< "" when there is no previous setting
  std::string change;    ///< "+12 %"; "" when the two cannot be compared
  double direction = 0;  ///< below 0: fell, above 0: rose
};

/// `before` may be null.
std::vector<MeasureRow> delta_rows(const Evaluation& now, const Evaluation* before);
std::vector<MeasureRow> lambda_rows(const Evaluation& now, const Evaluation* before);

}  // namespace bspview
