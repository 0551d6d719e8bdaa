#pragma once

#include <span>

#include "app/viewer/panels/ui.h"
#include "core/eval/trade_offs.h"

namespace bspview {

/// The setting that is marked in the chart.
struct ChartMark {
  Arithmetic arithmetic = Arithmetic::exact;
  Traversal traversal = Traversal::robust;
};

/// Run time against error, both logarithmic, over the width of the panel. Open circles: no wrong
/// ray was found, the error is below the mark.
void trade_off_chart(const Ui& ui, std::span<const TradeOffPoint> points, const ChartMark& mark);

}  // namespace bspview
