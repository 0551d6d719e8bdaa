#pragma once

#include <string>
#include <vector>

#include "app/viewer/evaluation.h"

namespace bspview {

/// One component of Delta or Lambda as the panel shows it.
struct MeasureRow {
  const char* name;     ///< as in JSON: N_LS
  const char* symbol;   ///< as the paper writes it; see symbols()
  std::string meaning;  ///< sentences, then the formula on a line of its own
  bool derived = false;
  std::string now;     ///< "–": not defined, or not known yet
  std::string before;  ///< "" when there is no previous setting
  std::string change;  ///< "+12 %"; "" when the two cannot be compared
  double benefit = 0;  ///< above 0: the current setting costs less, below 0: more
};

/// `before` may be null.
std::vector<MeasureRow> delta_rows(const Evaluation& now, const Evaluation* before);
std::vector<MeasureRow> lambda_rows(const Evaluation& now, const Evaluation* before);

}  // namespace bspview
